"""Curves through waypoints whose distances differ: they pass them, and do not swing out."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from roadlang.geometry import Curve, GeometryError, through_waypoints

legs = st.floats(5.0, 800.0)


@given(st.lists(st.tuples(legs, st.floats(-1.0, 1.0)), min_size=2, max_size=8), st.booleans())
def test_the_curve_passes_every_waypoint(steps: list[tuple[float, float]], closed: bool) -> None:
    ends = np.cumsum([length * np.exp(1j * turn) for length, turn in steps])
    points = np.array([(0.0, 0.0), *((z.real, z.imag) for z in ends)])
    if closed:
        points = np.concatenate([points, [(points[-1, 0] / 2, points[:, 1].min() - 200.0)]])
    curve = through_waypoints(points, closed)
    s, _ = curve.project(points)
    np.testing.assert_allclose(curve.at(s), points, atol=1e-6 * curve.length)


@given(before=st.floats(25.0, 2000.0), change=st.floats(20.0, 200.0), after=st.floats(25.0, 2000.0))
@pytest.mark.parametrize("split", [False, True])
def test_a_lane_change_stays_between_its_lanes(
    split: bool, before: float, change: float, after: float
) -> None:
    """Also where the straight legs have a waypoint in the middle."""
    assume(before >= change and after >= change)
    x = np.cumsum([0.0, before, change, after])
    points = [(x[0], 0.0), (x[1], 0.0), (x[2], -3.8), (x[3], -3.8)]
    if split:
        points.insert(1, (before / 2, 0.0))
        points.insert(4, (x[2] + after / 2, -3.8))
    curve = through_waypoints(points)
    lateral = curve.at(curve.stations(spacing=0.5))[:, 1]
    assert lateral.max() < 0.5
    assert lateral.min() > -4.3


@given(count=st.integers(3, 12), radius=st.floats(10.0, 1000.0))
def test_a_ring_of_even_waypoints_is_the_plain_spline(count: int, radius: float) -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    points = radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    ours, plain = through_waypoints(points, closed=True), Curve.through(points, closed=True)
    np.testing.assert_array_equal(ours.points, plain.points)


def test_a_long_leg_is_straight_beyond_its_ends() -> None:
    curve = through_waypoints([(0, 0), (300, 0), (310, 10), (310, 300)])
    s = curve.stations(spacing=1.0)
    on_leg = (curve.at(s)[:, 0] > 100.0) & (curve.at(s)[:, 0] < 280.0) & (curve.at(s)[:, 1] < 5)
    assert np.abs(curve.at(s)[on_leg, 1]).max() < 0.05


def test_two_points_are_a_straight_line() -> None:
    curve = through_waypoints([(0, 0), (30, 40)])
    assert curve.length == pytest.approx(50.0)


def test_coinciding_points_are_refused() -> None:
    with pytest.raises(GeometryError, match="at least 2 distinct points"):
        through_waypoints([(1, 1), (1, 1)])
