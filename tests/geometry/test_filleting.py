"""Straight lines with rounded corners."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from roadlang.geometry import GeometryError, filleted

corners = st.lists(
    st.tuples(st.sampled_from([0.0, 10.0, 30.0, 80.0]), st.sampled_from([0.0, 20.0, 45.0])),
    min_size=2,
    max_size=8,
)


def test_a_corner_is_an_arc_between_two_lines() -> None:
    curve = filleted([(0, 0), (50, 0), (50, 40)], radius=10.0)
    assert curve.length == pytest.approx(40 + 10 * np.pi / 2 + 30, rel=1e-6)
    assert curve.at([0.0, 40.0]) == pytest.approx(np.array([(0, 0), (40, 0)]), abs=1e-6)
    assert curve.at(curve.length) == pytest.approx(np.array((50, 40)), abs=1e-9)
    assert curve.curvature([20.0, 48.0, 70.0]) == pytest.approx([0.0, 0.1, 0.0], abs=1e-4)


def test_two_points_are_a_straight_line() -> None:
    curve = filleted([(0, 0), (30, 40)], radius=5.0)
    assert curve.length == pytest.approx(50.0)
    assert curve.curvature([0.0, 25.0, 50.0]) == pytest.approx([0.0] * 3, abs=1e-9)


def test_points_in_a_line_make_no_corner() -> None:
    curve = filleted([(0, 0), (10, 0), (10, 0), (30, 0)], radius=5.0)
    assert curve.length == pytest.approx(30.0)


def test_a_closed_line_has_a_corner_at_its_first_point() -> None:
    square = filleted([(0, 0), (40, 0), (40, 40), (0, 40)], radius=8.0, closed=True)
    assert square.closed
    assert square.length == pytest.approx(4 * (40 - 16) + 2 * np.pi * 8, rel=1e-6)
    assert square.at(0.0) == pytest.approx(np.array((8.0, 0.0)))
    s = square.stations(spacing=0.5)
    assert square.curvature(s).max() == pytest.approx(1 / 8, rel=1e-3)
    assert np.linalg.norm(square.at(s), axis=1).min() == pytest.approx(
        8 * (np.sqrt(2) - 1), abs=0.02
    )


def test_lines_too_short_for_the_radius_get_a_smaller_one() -> None:
    curve = filleted([(0, 0), (10, 0), (10, 100)], radius=50.0)
    assert curve.curvature(5.0 + 5 * np.pi / 4) == pytest.approx(1 / 5, rel=1e-3)
    assert curve.at(curve.length) == pytest.approx(np.array((10, 100)), abs=1e-9)


@given(corners, st.sampled_from([0.1, 5.0, 1000.0]), st.booleans())
def test_the_curve_stays_within_the_points_and_near_the_lines(
    points: Any, radius: float, closed: bool
) -> None:
    try:
        curve = filleted(points, radius, closed)
    except GeometryError:  # too few distinct points, or lines that turn right back
        assume(False)
    line = curve.at(curve.stations(spacing=0.25))
    array = np.array(points)
    assert (line >= array.min(axis=0) - 1e-3).all()
    assert (line <= array.max(axis=0) + 1e-3).all()
    assert curve.closed == closed
    if not closed:
        assert line[0] == pytest.approx(array[0], abs=1e-9)
        assert line[-1] == pytest.approx(array[-1], abs=1e-3)


@pytest.mark.parametrize("radius", [0.0, -1.0, np.inf, np.nan])
def test_a_radius_is_positive(radius: float) -> None:
    with pytest.raises(GeometryError, match="radius of a fillet must be positive"):
        filleted([(0, 0), (10, 0), (10, 10)], radius)


def test_lines_that_turn_right_back_are_refused_with_the_place() -> None:
    with pytest.raises(GeometryError, match=r"turn right back at \(50 m, 0 m\)"):
        filleted([(0, 0), (50, 0), (10, 0)], radius=5.0)
    with pytest.raises(GeometryError, match=r"turn right back at \(0 m, 0 m\)"):
        filleted([(0, 0), (50, 0), (50, 9), (90, 0)], radius=5.0, closed=True)


def test_corners_that_hardly_turn_are_passed_straight() -> None:
    """Their fillets would be shorter than points of a curve may be apart."""
    points = np.column_stack((np.arange(0.0, 60.0, 0.5), np.zeros(120)))
    points[:, 1] += 4e-10 * (-1.0) ** np.arange(120)
    curve = filleted(points, radius=15.0)
    assert curve.length == pytest.approx(59.5)
    assert curve.at([0.0, curve.length]) == pytest.approx(points[[0, -1]], abs=1e-6)


@pytest.mark.parametrize("closed", [False, True])
def test_turns_too_slight_for_a_fillet_do_not_move_the_end(closed: bool) -> None:
    """A turn of 1e-7 over 500 m is 5e-5 m."""
    x = np.array([0.0, 10.0, 20.0, 30.0, 530.0])
    points = np.column_stack((x, np.array([0.0, 0.0, 1e-6, 3e-6, 1e-4])))
    points = np.concatenate([points, [(530.0, 90.0), (0.0, 90.0)]])
    curve = filleted(points, radius=5.0, closed=closed)
    if not closed:
        assert curve.at([0.0, curve.length]) == pytest.approx(points[[0, -1]], abs=1e-8)
    away = np.abs(curve.project(np.array([(200.0, 4e-5), (300.0, 90.0)]))[1])
    assert away.max() < 2e-5
