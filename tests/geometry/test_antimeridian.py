"""Lines and areas around 180 degrees, on a plane of degrees."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang.geometry import Floats
from roadlang.geometry.earth.antimeridian import cut_area, cut_line


def ring(*points: tuple[float, float]) -> Floats:
    return np.array([*points, points[0]])


def area(closed: Floats) -> float:
    x, y = closed.T
    return float(x[:-1] @ y[1:] - x[1:] @ y[:-1]) / 2.0


def test_what_stays_on_one_side_is_left_as_it_is() -> None:
    line = np.array([[179.0, 0.0], [180.0, 1.0]])
    assert cut_line(line)[0] is line
    square = ring((-180.0, 0.0), (-179.0, 0.0), (-179.0, 1.0), (-180.0, 1.0))
    assert cut_area([square])[0][0] is square


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_line_ends_at_180_and_goes_on_at_minus_180(sign: float) -> None:
    east, west = cut_line(np.array([[sign * 179.0, 10.0], [sign * 181.0, 12.0]]))
    assert east.tolist() == [[sign * 179.0, 10.0], [sign * 180.0, 11.0]]
    assert west.tolist() == [[-sign * 180.0, 11.0], [-sign * 179.0, 12.0]]


def test_a_line_that_crosses_twice_has_three_parts() -> None:
    parts = cut_line(np.array([[179.0, 0.0], [181.0, 2.0], [179.0, 4.0]]))
    assert [part[:, 1].tolist() for part in parts] == [[0.0, 1.0], [1.0, 2.0, 3.0], [3.0, 4.0]]
    assert all(abs(part[:, 0]).max() <= 180.0 for part in parts)


def test_a_line_that_only_touches_has_one_part() -> None:
    (part,) = cut_line(np.array([[179.0, 0.0], [180.0, 1.0], [179.0, 2.0]]))
    assert len(part) == 3


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_square_becomes_two(sign: float) -> None:
    west, east = (179.5, 181.0) if sign > 0 else (-181.0, -179.5)
    parts = cut_area([ring((west, 0.0), (east, 0.0), (east, 2.0), (west, 2.0))])
    assert sorted(area(outer) for (outer,) in parts) == pytest.approx([1.0, 2.0])
    assert all(abs(outer[:, 0]).max() == 180.0 for (outer,) in parts)
    assert all(outer[0].tolist() == outer[-1].tolist() for (outer,) in parts)


def test_a_horseshoe_that_opens_across_has_two_parts_beyond() -> None:
    """Its back is before 180 degrees, both of its arms reach beyond."""
    shoe = ring((179.0, 0.0), (181.0, 0.0), (181.0, 1.0), (179.5, 1.0),
                (179.5, 2.0), (181.0, 2.0), (181.0, 3.0), (179.0, 3.0))  # fmt: skip
    parts = cut_area([shoe])
    assert sorted(area(outer) for (outer,) in parts) == pytest.approx([1.0, 1.0, 2.5])
    assert sum(area(outer) for (outer,) in parts) == pytest.approx(area(shoe))


def test_a_hole_that_crosses_is_open_on_both_sides_and_others_stay_holes() -> None:
    outer = ring((178.0, 0.0), (182.0, 0.0), (182.0, 4.0), (178.0, 4.0))
    across = ring((179.5, 1.0), (179.5, 2.0), (180.5, 2.0), (180.5, 1.0))
    before = ring((178.5, 3.0), (178.5, 3.5), (179.0, 3.5), (179.0, 3.0))
    parts = cut_area([outer, across, before])
    assert [len(rings) for rings in parts] == [2, 1]
    assert [sum(map(area, rings)) for rings in parts] == pytest.approx([7.25, 7.5])
