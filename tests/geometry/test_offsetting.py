"""Edges of roads: beside the curve, never folded."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import (
    Arc,
    CurveBatch,
    GeometryError,
    Road,
    Straight,
    WidthProfile,
    chain,
    offset,
)
from tests.geometry.geometry_shapes import circle, curves, hairpin, line, self_intersects, wave


def corner(radius: float, angle: float = np.pi / 2) -> Any:
    return chain([Straight(40.0), Arc(radius, angle), Straight(40.0)], spacing=0.5).curve()


def runs_backwards(curve: Any, stations: Any, points: Any) -> Any:
    base, line = curve.at(stations), points
    if curve.closed:
        base, line = np.concatenate([base, base[:1]]), np.concatenate([line, line[:1]])
    return ((np.diff(base, axis=0) * np.diff(line, axis=0)).sum(axis=1) < -1e-9).any()


@given(curves(), st.floats(-2.0, 2.0))
def test_a_gentle_offset_is_the_parallel_curve(curve: Any, distance: float) -> None:
    s = curve.stations(count=200)
    if (1.0 - curve.curvature(s) * distance < 0.05).any():
        return
    expected = curve.at(s) + distance * curve.normal(s)
    np.testing.assert_array_equal(offset(curve, distance, s), expected)


def test_inside_a_tight_corner_the_edges_meet_in_a_point() -> None:
    road = corner(radius=2.0)
    s = road.stations(count=400)
    inside = offset(road, 5.0, s)
    assert not runs_backwards(road, s, inside)
    np.testing.assert_allclose(inside[inside[:, 0] < 36.9][:, 1], 5.0, atol=1e-6)
    assert np.linalg.norm(inside - (37.0, 5.0), axis=1).min() < 1e-3
    assert not self_intersects(CurveBatch(s[::7], inside[None, ::7]))[0]


@given(st.floats(0.5, 12.0), st.floats(0.2, 2.4) | st.floats(-2.4, -0.2), st.floats(-8.0, 8.0))
def test_no_corner_folds_or_loops(radius: float, angle: float, distance: float) -> None:
    road = corner(radius, angle)
    s = road.stations(count=300)
    edge = offset(road, distance, s)
    assert not runs_backwards(road, s, edge)
    steps = np.linalg.norm(np.diff(edge, axis=0), axis=1) > 1e-6
    distinct = np.concatenate([edge[:1], edge[1:][steps]])
    assert not self_intersects(CurveBatch(np.arange(len(distinct)), distinct[None]))[0]


@given(curves(), st.floats(-15.0, 15.0))
def test_no_curve_s_edge_runs_backwards(curve: Any, distance: float) -> None:
    s = curve.stations(count=150)
    assert not runs_backwards(curve, s, offset(curve, distance, s))


def test_a_half_turn_tighter_than_the_offset_collapses_into_its_center() -> None:
    road = hairpin(radius=3.0)
    s = road.stations(count=500)
    inside = offset(road, 5.0, s)
    assert not runs_backwards(road, s, inside)
    assert np.linalg.norm(inside - (40.0, 3.0), axis=1).min() < 0.05


def test_a_ring_smaller_than_the_offset_becomes_its_center() -> None:
    ring = circle(radius=3.0)
    inside = offset(ring, 5.0, ring.stations(count=100))
    np.testing.assert_allclose(inside, 0.0, atol=0.05)


def test_a_ring_keeps_its_seam() -> None:
    ring = circle(radius=10.0)
    s = ring.stations(count=100)
    np.testing.assert_allclose(np.linalg.norm(offset(ring, 4.0, s), axis=1), 6.0, atol=1e-3)


@pytest.mark.parametrize("share", [0.0, 0.2, 0.5, 0.9])
def test_a_ring_may_begin_in_a_bend_tighter_than_the_offset(share: float) -> None:
    """A rounded square, 40 m wide with corners of 4 m, seen from 7 m inside: a square of 26 m."""
    corner, side = Arc(4.0, np.pi / 2), Straight(32.0)
    begun = Arc(4.0, (1.0 - share) * np.pi / 2)
    pieces: list[Any] = [begun, side, corner, side, corner, side, corner, side]
    if share:
        pieces.append(Arc(4.0, share * np.pi / 2))
    ring = chain(pieces, heading=share * np.pi / 2, spacing=0.5).curve(closed=True)
    inside = offset(ring, 7.0, ring.stations(count=400))
    middle = (inside.min(axis=0) + inside.max(axis=0)) / 2
    np.testing.assert_allclose(np.abs(inside - middle).max(axis=1), 13.0, atol=0.1)


def test_edges_follow_the_width() -> None:
    road = Road(line(100.0), WidthProfile(np.array([0.0, 100.0]), np.array([4.0, 8.0])))
    left, right = road.edges([0.0, 50.0, 100.0])
    np.testing.assert_allclose(left[:, 1], [2.0, 3.0, 4.0])
    np.testing.assert_allclose(right[:, 1], [-2.0, -3.0, -4.0])
    np.testing.assert_allclose(road.outline([0.0, 100.0]), [(0, -2), (100, -4), (100, 4), (0, 2)])


@pytest.mark.parametrize(
    ("lanes", "ids", "middles"),
    [
        (1, (-1,), [0.0]),
        (2, (1, -1), [1.5, -1.5]),
        (3, (1, -1, -2), [2.0, 0.0, -2.0]),
        (4, (2, 1, -1, -2), [2.25, 0.75, -0.75, -2.25]),
    ],
)
def test_lanes_share_the_width_and_have_the_ids_of_opendrive(
    lanes: int, ids: tuple[int, ...], middles: list[float]
) -> None:
    road = Road(wave(), WidthProfile.constant(6.0), lanes)
    assert road.lane_ids == ids
    assert [float(road.lane_offset(lane, 10.0)) for lane in ids] == pytest.approx(middles)
    assert float(road.lane_width(-1, 3.0)) == pytest.approx(6.0 / lanes)
    assert len(road.lane_lines(road.curve.stations(count=20))) == lanes - 1
    with pytest.raises(GeometryError, match=f"its lanes are {ids[0]}"):
        road.lane_offset(9, 0.0)


def test_widths_are_linear_between_and_go_round_on_a_ring() -> None:
    open_width = WidthProfile.even([4.0, 8.0], length=10.0)
    np.testing.assert_allclose(open_width.at([-5.0, 0.0, 5.0, 10.0, 15.0]), [4, 4, 6, 8, 8])
    ring = WidthProfile.even([4.0, 8.0], length=10.0, closed=True)
    np.testing.assert_allclose(ring.at([0.0, 2.5, 5.0, 7.5, 10.0]), [4, 6, 8, 6, 4])
    np.testing.assert_allclose(ring.scaled(2.0).at([5.0, 15.0]), [12.0, 12.0])


@pytest.mark.parametrize(
    ("stations", "widths"),
    [([], []), ([0.0], [0.0]), ([0.0], [-1.0]), ([1.0, 0.0], [3.0, 3.0]), ([0.0], [np.nan])],
)
def test_impossible_widths_are_refused(stations: Any, widths: Any) -> None:
    with pytest.raises(GeometryError):
        WidthProfile(np.array(stations), np.array(widths))
