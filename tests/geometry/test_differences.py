"""Derivatives by differences: of parabolas exact, and the same in whatever company a row comes."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang.geometry import GeometryError
from roadlang.geometry.numbers.differences import Differences, derivative

EVEN = np.linspace(0.0, 30.0, 101)
UNEVEN = EVEN + 0.1 * np.sin(EVEN)


@pytest.mark.parametrize("stations", [EVEN, UNEVEN])
def test_a_parabola_has_exact_derivatives_up_to_its_ends(stations: np.ndarray) -> None:
    heights = np.array([[1.0], [-4.0]])
    rows = heights * stations**2
    np.testing.assert_allclose(derivative(rows, stations), 2.0 * heights * stations, atol=1e-10)
    bend = derivative(rows, stations, order=2)
    np.testing.assert_allclose(bend, np.broadcast_to(2.0 * heights, bend.shape), atol=1e-8)


@pytest.mark.parametrize("stations", [EVEN, UNEVEN])
@pytest.mark.parametrize("period", [None, 31.0])
@pytest.mark.parametrize("order", [1, 2])
def test_a_row_has_the_same_derivative_in_whatever_company(
    stations: np.ndarray, period: float | None, order: int
) -> None:
    """Bit for bit: a scene that is made again alone is the scene that was made among thousands."""
    rows = np.random.default_rng(5).normal(size=(67, len(stations)))
    differences = Differences(stations, period)
    together = differences.derivative(rows, order)
    for first in (0, 1, 3, 64):
        for last in (first + 1, first + 2, first + 3):
            alone = differences.derivative(rows[first:last], order)
            np.testing.assert_array_equal(alone, together[first:last])
    every_second = differences.derivative(rows[::2, :], order)
    np.testing.assert_array_equal(every_second, together[::2])


def test_a_row_of_one_dimension_and_an_array_to_write_to() -> None:
    out = np.empty((1, len(EVEN)))
    found = Differences(EVEN).derivative(np.sin(EVEN)[None], 1, out)
    assert found is out
    np.testing.assert_array_equal(derivative(np.sin(EVEN), EVEN), out[0])


def test_stations_that_do_not_increase_are_refused() -> None:
    for stations, period in ((EVEN[:2], None), (EVEN[::-1], None), (EVEN, 30.0)):
        with pytest.raises(GeometryError):
            Differences(stations, period)
