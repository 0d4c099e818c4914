"""A displaced road never runs backwards: what `folded` refuses, and what holds of all the rest."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import Arc, CurveBatch, CurveFrame, Straight, chain, displace, sample
from roadlang.geometry.batches.folding import LEAST_ADVANCE, turns_too_much
from tests.geometry.geometry_shapes import circle, curves, line

rates = st.sampled_from([0.0, 0.02, 0.1, 0.5, 1.5]) | st.floats(0.0, 1.5)
heights = st.sampled_from([0.0, -30.0, 30.0]) | st.floats(-30.0, 30.0)


def steps_of(batch: Any, row: Any = 0) -> Any:
    points = batch.points[row]
    if batch.closed:
        points = np.concatenate([points, points[:2]])
    return np.diff(points, axis=0)


def turns_of(batch: Any, row: Any = 0) -> Any:
    """Radians from each step to the next."""
    steps = steps_of(batch, row)
    before, after = steps[:-1], steps[1:]
    across = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    return np.arctan2(across, (before * after).sum(axis=1))


def exactly_folded(frame: Any, moves: Any) -> Any:
    """What `folded` says without its quick test."""
    batch = displace(frame, frame.stations, moves)
    again = turns_too_much(batch.curvature, batch.steps, batch.closed)
    return frame.steps.folded(moves) | again


def test_a_bend_pushed_to_its_center_is_folded_before_it_has_no_length_left() -> None:
    ring = circle(radius=10.0, count=200)
    s = ring.stations(count=100)
    moves = np.array([[9.0], [9.4], [9.6], [10.0], [11.0], [-50.0]]) * np.ones((6, 100))
    np.testing.assert_array_equal(
        displace(ring, s, moves).folded, [False, False, True, True, True, False]
    )


def test_a_bump_into_the_center_of_a_tight_bend_is_folded() -> None:
    road = chain([Straight(30.0), Arc(5.0, np.radians(170)), Straight(30.0)], spacing=0.5).curve()
    s = road.stations(count=int(road.length) + 2)
    x = np.clip((s - 37.0) / 30.0, -1.0, 1.0)
    moves = np.array([[4.99], [3.0]]) * (1.0 - x * x) ** 3
    np.testing.assert_array_equal(displace(road, s, moves).folded, [True, False])


@pytest.mark.parametrize(
    ("closed", "means"), [(False, [1.0, 2.0, 4.0, 5.0]), (True, [3.0, 2.0, 4.0])]
)
def test_a_quarter_turn_over_the_mean_of_the_steps_at_a_station(
    closed: bool, means: list[float]
) -> None:
    lengths = np.array([[1.0, 3.0, 5.0]])
    for at, mean in enumerate(means):
        for share in (0.99, -0.99, 1.01, -1.01):
            curvature = np.zeros((1, len(means)))
            curvature[0, at] = share * np.pi / 2.0 / mean
            assert turns_too_much(curvature, lengths, closed).tolist() == [abs(share) > 1.0]


def test_a_bend_between_two_stations_counts() -> None:
    """At the stations the road is straight; it turns by 80 degrees between two of them."""
    road = chain([Straight(9.75), Arc(0.3, np.radians(80)), Straight(10.0)], spacing=0.01).curve()
    s = np.array([0.0, 3.0, 6.0, 9.0, 12.0, 15.0, 18.0])
    frame = CurveFrame.of(road, s)
    assert np.abs(frame.curvature).max() < 1e-3
    np.testing.assert_array_equal(
        displace(frame, s, np.full((2, 7), [[1.0], [4.0]])).folded, [False, True]
    )


def test_a_zigzag_turns_by_more_than_a_quarter() -> None:
    road = line(20.0)
    s = road.stations(count=21)
    zigzag = np.where(np.arange(21) % 2, 1.0, -1.0)
    batch = displace(road, s, np.array([[0.3], [0.51]]) * zigzag)
    np.testing.assert_array_equal(batch.folded, [False, True])
    np.testing.assert_array_equal(CurveBatch(s, batch.points).folded, [False, True])


def test_stations_of_a_line_of_points_must_keep_apart() -> None:
    s = np.arange(5.0)
    points = np.stack([np.cumsum([0.0, 1.0, 0.04, 1.0, 1.0]), np.zeros(5)], axis=1)
    assert CurveBatch(s, points[None]).folded.all()
    points[2:, 0] += 0.02
    assert not CurveBatch(s, points[None]).folded.any()


@pytest.mark.parametrize("closed", [False, True])
def test_the_seam_of_a_closed_road_counts(closed: bool) -> None:
    ring = circle(radius=30.0, count=200)
    s = ring.stations(count=100)
    moves = np.zeros((1, 100))
    moves[0, 0], moves[0, -1] = 3.0, -3.0
    points = displace(ring, s, moves).points
    period = ring.length if closed else None
    assert CurveBatch(s, points, closed, period).folded[0] == closed
    assert displace(ring, s, moves).folded.all()


@given(curves(), heights, rates, st.floats(-4.0, 4.0))
def test_what_is_not_folded_goes_on_and_turns_less_than_a_quarter(
    curve: Any, height: float, rate: float, phase: float
) -> None:
    s = curve.stations(spacing=1.0)
    moves = height * np.sin(rate * s + phase)
    batch = displace(curve, s, moves)
    gap = s[1]
    again = displace(batch, s, 0.5 * moves)
    for made, least in ((batch, LEAST_ADVANCE * gap), (again, LEAST_ADVANCE * gap)):
        if not made.folded[0]:
            assert np.abs(turns_of(made)).max() < np.pi / 2
            assert np.hypot(*steps_of(made).T).min() > least
            assert np.abs(made.curvature).max() < np.pi / 2 / least
    assert again.folded[0] or not batch.folded[0]


@given(curves(), heights, rates)
def test_the_quick_test_lets_nothing_pass_that_is_folded(
    curve: Any, height: float, rate: float
) -> None:
    s = curve.stations(spacing=1.0)
    frame = CurveFrame.of(curve, s)
    moves = height * np.linspace(0.0, 1.0, 16)[:, None] * np.cos(rate * s)
    sure = frame.steps.surely_smooth(moves)
    assert not (sure & exactly_folded(frame, moves)).any()
    assert sure[0] or np.abs(turns_of(sample(curve, s))).max() > np.pi / 2


@pytest.mark.parametrize("height", [8.0, 14.0])
@pytest.mark.parametrize("wavelength", [60.0, 200.0])
def test_the_quick_test_decides_wide_waves_on_a_country_road(
    height: float, wavelength: float
) -> None:
    road = chain([Straight(100.0), Arc(60.0, np.radians(80)), Straight(100.0)], spacing=1.0).curve()
    s = road.stations(spacing=1.0)
    phase = np.linspace(0.0, 2.0 * np.pi, 32)[:, None]
    moves = height * np.sin(2.0 * np.pi / wavelength * s + phase)
    assert CurveFrame.of(road, s).steps.surely_smooth(moves).all()


@given(curves(), st.floats(-8.0, 8.0), rates)
def test_rows_do_not_depend_on_each_other(curve: Any, height: float, rate: float) -> None:
    s = curve.stations(spacing=1.0)
    moves = height * np.linspace(0.0, 2.0, 9)[:, None] * np.cos(rate * s)
    batch = displace(curve, s, moves)
    again = displace(batch, s, moves)
    for row in range(9):
        rows = np.array([row])
        assert displace(curve, s, moves[rows]).folded[0] == batch.folded[row]
        assert again.take(rows).folded[0] == again.folded[row]


def test_a_turn_of_exactly_a_quarter_is_folded() -> None:
    s = np.arange(3.0)
    corner = np.array([[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)], [(0.0, 0.0), (1.0, 0.0), (1.5, 1.0)]])
    np.testing.assert_array_equal(CurveBatch(s, corner).folded, [True, False])


def test_a_road_made_from_a_folded_one_is_folded_also_where_it_is_pushed_back() -> None:
    ring = circle(radius=10.0, count=200)
    s = ring.stations(count=100)
    there = displace(ring, s, np.array([[11.0], [5.0]]) * np.ones((2, 100)))
    np.testing.assert_array_equal(there.folded, [True, False])
    away = np.array([[[500.0, 0.0]] * 100])
    np.testing.assert_array_equal(displace(there, s, away).folded, [True, False])


def test_the_speed_of_a_road_pushed_twice_is_that_of_its_points() -> None:
    ring = circle(radius=20.0, count=400)
    s = ring.stations(count=200)
    even = np.ones((1, 200))
    twice = displace(displace(ring, s, 8.0 * even), s, 4.0 * even)
    np.testing.assert_allclose(twice.speed, 8.0 / 20.0, rtol=1e-3)
    np.testing.assert_allclose(twice.curvature, 1.0 / 8.0, rtol=1e-3)
