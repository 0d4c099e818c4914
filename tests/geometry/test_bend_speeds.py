"""Speeds before bends, compared with what braking does."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry.curves.bend_speeds import square_before, squares_before, squares_in_bends


def test_a_bend_is_driven_at_the_lateral_acceleration() -> None:
    (square,) = squares_in_bends(np.array([-1 / 50.0]), 4.5)
    assert square / 50.0 == pytest.approx(4.5)


def test_what_is_straight_has_a_finite_limit_beyond_all_speeds() -> None:
    (square,) = squares_in_bends(np.zeros(1), 4.5)
    assert 1000.0 < math.sqrt(square) < math.inf


@given(
    st.lists(st.floats(0.0, 900.0), min_size=1, max_size=20),
    st.floats(0.1, 10.0),
    st.floats(0.1, 5.0),
)
def test_every_place_allows_to_brake_for_every_bend_ahead(
    limits: list[float], braking: float, step: float
) -> None:
    row = np.array(limits)
    found = squares_before(row[None, :], np.array([2.0 * braking * step]))[0]
    for place in range(len(row)):
        ahead = np.asarray(step * np.arange(len(row) - place), dtype=np.float64)
        assert found[place] == pytest.approx(square_before(row[place:], ahead, braking), abs=1e-9)
        assert found[place] <= row[place] + 1e-9


def test_without_bends_nothing_limits_the_speed() -> None:
    assert square_before(np.zeros(0), np.zeros(0), 3.0) == math.inf
