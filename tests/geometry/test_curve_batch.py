"""Many variants of a curve at once."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import (
    Arc,
    Curve,
    CurveBatch,
    DisplacedBatch,
    GeometryError,
    Straight,
    chain,
    displace,
    sample,
)
from tests.geometry.geometry_shapes import circle, curves, line, walks, wave


def sine(stations: Any, amplitude: float, wavelength: float) -> Any:
    """A displacement and its two derivatives."""
    rate = 2 * np.pi / wavelength
    value = amplitude * np.sin(rate * stations)
    return value, amplitude * rate * np.cos(rate * stations), -(rate**2) * value


def test_a_circle_displaced_evenly_is_the_parallel_circle() -> None:
    ring = circle(radius=10.0, count=400)
    s = ring.stations(count=200)
    batch = displace(ring, s, np.array([[3.0], [-4.0]]) * np.ones((2, 200)))
    np.testing.assert_allclose(np.linalg.norm(batch.points, axis=-1), [[7.0] * 200, [14.0] * 200])
    np.testing.assert_allclose(batch.curvature[0], 1 / 7, rtol=1e-4)
    np.testing.assert_allclose(batch.curvature[1], 1 / 14, rtol=1e-4)
    np.testing.assert_allclose(batch.length, 2 * np.pi * np.array([7.0, 14.0]), rtol=1e-3)


def test_a_sine_on_a_straight_has_the_heading_and_curvature_of_the_sine() -> None:
    road = line(200.0)
    s = road.stations(count=500)
    value, slope, bend = sine(s, 4.0, 60.0)
    batch = displace(road, s, value)
    inner = slice(1, -1)
    exact = (bend / (1 + slope**2) ** 1.5)[inner]
    np.testing.assert_allclose(batch.curvature[0, inner], exact, atol=1e-4)
    np.testing.assert_allclose(batch.heading[0], np.arctan(slope), atol=1e-3)


@given(walks(smallest=3), st.floats(-2.0, 2.0), st.floats(30.0, 90.0))
def test_a_displaced_road_agrees_with_the_spline_through_its_points(
    points: Any, amplitude: float, wavelength: float
) -> None:
    road = Curve.through(points).resampled(spacing=1.0)
    s = road.stations(spacing=0.25)
    batch = displace(road, s, sine(s, amplitude, wavelength)[0])
    inner = slice(10, -10)
    through = batch.curve(0)
    at, _ = through.project(batch.points[0])
    turned = np.abs(np.diff(batch.curvature[0], append=batch.curvature[0, -1])).max()
    tolerance = 2 * turned + 5e-3
    np.testing.assert_allclose(
        through.curvature(at)[inner], batch.curvature[0][inner], atol=tolerance
    )
    np.testing.assert_allclose(through.heading(at)[inner], batch.heading[0][inner], atol=0.01)


@pytest.mark.parametrize("closed", [False, True])
def test_the_curvature_converges_with_the_square_of_the_gap(closed: bool) -> None:
    road = circle(radius=30.0, count=600) if closed else wave()

    def curvature(count: int) -> Any:
        s = road.stations(count=count + (not closed))
        return displace(road, s, sine(s, 2.0, road.length / 4)[0]).curvature[0]

    def error(count: int) -> Any:
        exact = curvature(3200)[:: 3200 // count]
        return np.abs(curvature(count) - exact)[1:-1].max()

    # The spline itself has kinks in its curvature, so that the order shows only on the ring.
    assert error(400) < error(200) / (3.0 if closed else 2.0)
    assert error(200) < 1e-3


@given(curves(), st.floats(-4.0, 4.0), st.floats(20.0, 90.0))
def test_displacing_again_by_nothing_changes_nothing(
    curve: Any, amplitude: float, length: float
) -> None:
    s = curve.stations(spacing=1.0)
    once = displace(curve, s, sine(s, amplitude, length)[0])
    for nothing in (np.zeros((1, len(s))), np.zeros((1, len(s), 2))):
        again = displace(once, s, nothing)
        np.testing.assert_array_equal(again.points, once.points)
        np.testing.assert_allclose(again.heading, once.heading, atol=1e-12)
        np.testing.assert_allclose(again.curvature, once.curvature, atol=1e-9, rtol=1e-9)
        np.testing.assert_allclose(again.speed, once.speed)


@given(curves(), st.floats(-3.0, 3.0), st.floats(40.0, 90.0))
def test_two_displacements_are_one_of_their_sum_along_the_same_normals(
    curve: Any, amplitude: float, length: float
) -> None:
    s = curve.stations(spacing=0.25)
    waves = max(1, round(curve.length / length)) if curve.closed else curve.length / length
    e = sine(s, amplitude, curve.length / waves)[0]
    normal = displace(curve, s, 0.0 * s).normal[0]
    once = displace(curve, s, e)
    twice = displace(displace(curve, s, 0.4 * e), s, ((0.6 * e)[:, None] * normal)[None])
    np.testing.assert_allclose(twice.points, once.points, atol=1e-12)
    if not once.folded[0]:
        # At knots, where the base's curvature changes its slope, differences over 0.25 m round
        # curvature off; along the road they agree.
        inner = slice(2, -2)
        apart = np.abs(twice.curvature - once.curvature)[0, inner].mean()
        assert apart < 0.01 + 0.05 * np.abs(once.curvature[0, inner]).mean()
        assert np.abs(twice.heading - once.heading).mean() < 0.01


def test_the_kink_that_a_displaced_joint_of_arcs_has_is_in_the_curvature() -> None:
    """Where the base's curvature jumps, the heading of what slopes against it jumps too."""
    road = chain([Straight(30.0), Arc(10.0, 1.0), Straight(30.0)], spacing=0.5).curve()
    s = np.arange(0.2, road.length, 0.5)
    batch = displace(road, s, 4.0 + 1.5 * np.sin((s - 30.25) / 2.5))
    kink = np.arctan2(0.6, 1.0 - 0.1 * 4.0) - np.arctan2(0.6, 1.0)
    assert kink > 0.2
    near = slice(50, 71)
    turned = np.trapezoid((batch.curvature[0] * batch.speed[0])[near], s[near])
    assert turned == pytest.approx(batch.heading[0, 70] - batch.heading[0, 50], abs=0.05)
    assert batch.curvature[0, 59:61].sum() > kink / 0.5
    points = CurveBatch(s, batch.points)
    np.testing.assert_allclose(batch.curvature[0, near], points.curvature[0, near], atol=0.3)


@given(st.floats(0.5, 500.0), st.floats(-1e4, 1e4), st.sampled_from([1.0, -1.0]), st.booleans())
def test_three_points_of_a_circle_tell_its_curvature(
    radius: float, east: float, turn: float, closed: bool
) -> None:
    angle = turn * 2 * np.pi * np.arange(24) / 24
    points = radius * np.stack([np.cos(angle), np.sin(angle)], axis=-1) + (east, 0.0)
    batch = CurveBatch(np.arange(24.0), points[None], closed)
    np.testing.assert_allclose(batch.curvature, turn / radius, rtol=1e-6)


def test_the_curvature_of_two_points_and_of_points_that_coincide_is_zero() -> None:
    two = CurveBatch([0.0, 1.0], [[(0.0, 0.0), (1.0, 1.0)]])
    np.testing.assert_array_equal(two.curvature, [[0.0, 0.0]])
    same = CurveBatch(np.arange(4.0), np.ones((1, 4, 2)), closed=True)
    np.testing.assert_array_equal(same.curvature, np.zeros((1, 4)))


def test_a_corner_counts_at_its_point_and_nowhere_else() -> None:
    s = np.arange(5.0)
    points = np.array([(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (2.0, 2.0)])
    np.testing.assert_allclose(CurveBatch(s, points[None]).curvature, [[0, 0, np.sqrt(2), 0, 0]])


def test_uneven_stations_are_allowed() -> None:
    road = line(100.0)
    s = np.cumsum(np.tile([0.1, 0.3], 200))
    value, slope, _ = sine(s, 2.0, 50.0)
    batch = displace(road, s, value)
    np.testing.assert_allclose(batch.heading[0], np.arctan(slope), atol=1e-3)


@given(curves())
def test_no_displacement_is_the_curve_itself(curve: Any) -> None:
    s = curve.stations(count=60)
    batch = sample(curve, s)
    np.testing.assert_array_equal(batch.points[0], curve.at(s))
    np.testing.assert_array_equal(batch.heading[0], curve.heading(s))
    if np.abs(curve.curvature(s)).max() * s[1] < np.pi / 2:
        assert not batch.folded.any()


def test_displacements_add_up_when_a_batch_is_displaced_again() -> None:
    road = line(50.0)
    s = road.stations(count=51)
    twice = displace(displace(road, s, np.full((2, 51), 1.0)), s, np.full((2, 51), 2.0))
    np.testing.assert_allclose(twice.points[..., 1], 3.0)


def test_a_displacement_in_the_plane_moves_each_point_as_it_says() -> None:
    ring = circle(radius=20.0, count=200)
    s = ring.stations(count=100)
    shift = np.stack([0.5 * ring.at(s), np.full((100, 2), (3.0, -4.0))])
    batch = displace(ring, s, shift)
    np.testing.assert_allclose(np.linalg.norm(batch.points[0], axis=-1), 30.0, rtol=1e-6)
    np.testing.assert_allclose(batch.curvature[0], 1 / 30, rtol=1e-3)
    np.testing.assert_allclose(batch.points[1], ring.at(s) + np.array([3.0, -4.0]))
    assert not batch.folded.any()
    again = displace(batch, s, -shift)
    np.testing.assert_allclose(again.points, np.stack([ring.at(s)] * 2), atol=1e-12)


def test_a_road_shrunk_to_a_point_is_folded() -> None:
    ring = circle(radius=20.0, count=200)
    s = ring.stations(count=100)
    middle = -ring.at(s)
    batch = displace(ring, s, np.array([0.9, 0.96, 1.0])[:, None, None] * middle)
    np.testing.assert_array_equal(batch.folded, [False, True, True])


@pytest.mark.parametrize("computed_before", [True, False])
def test_variants_taken_twice_are_those_of_the_whole_batch(computed_before: bool) -> None:
    s = np.linspace(0.0, 60.0, 61)
    bends = np.array([0.5, -1.0, 1.5, 2.0])[:, None] * np.sin(s / 7.0)
    once = displace(line(60.0), s, bends)
    batch = displace(once, s, 0.3 * bends[::-1])
    names = ("points", "heading", "speed", "curvature", "length", "folded", "normal")
    fresh = {name: getattr(batch.take(np.arange(4)), name) for name in names}
    if computed_before:
        for name in names:
            getattr(batch, name)
            getattr(once, name)
    chosen = batch.take(np.array([False, True, True, True])).take([2, 0])
    for name in names:
        np.testing.assert_array_equal(getattr(chosen, name), fresh[name][[3, 1]], err_msg=name)
    for each in (batch, batch.take([3, 1]).take([0, 1])):
        rows = np.array([3, 1]) if each is batch else np.array([0, 1])
        np.testing.assert_array_equal(each.heading_of(rows), fresh["heading"][[3, 1]])


def test_the_heading_of_variants_takes_nothing_else_of_what_they_were_made_from() -> None:
    s = np.linspace(0.0, 60.0, 61)
    bends = np.array([0.5, -1.0, 1.5])[:, None] * np.sin(s / 7.0)
    chosen = displace(displace(line(60.0), s, bends), s, 0.3 * bends).take([2, 0])
    assert chosen.heading.shape == (2, 61)
    assert "base" not in vars(chosen)


def test_taking_variants_takes_their_base_along() -> None:
    road = wave()
    s = road.stations(count=50)
    moves = np.stack([k * sine(s, 1.0, 50.0)[0] for k in (0.0, 1.0, 60.0)])
    batch = displace(road, s, moves)
    chosen = batch.take(np.array([True, False, True]))
    assert isinstance(chosen, DisplacedBatch)
    np.testing.assert_array_equal(chosen.curvature, batch.curvature[[0, 2]])
    again = displace(batch, s, -moves)
    np.testing.assert_array_equal(again.take([0, 2]).folded, again.folded[[0, 2]])
    assert again.folded[2] > again.folded[0]


def test_rows_do_not_depend_on_their_neighbors() -> None:
    road = wave()
    s = road.stations(count=333)
    moves = np.random.default_rng(0).normal(size=(100, 333))
    together = displace(road, s, moves)
    alone = displace(road, s, moves[77:78])
    for name in ("points", "heading", "curvature", "folded"):
        np.testing.assert_array_equal(getattr(together, name)[77:78], getattr(alone, name))


def test_shapes_that_do_not_fit_are_refused() -> None:
    road = line()
    s = road.stations(count=10)
    for call in (
        lambda: displace(road, s, np.zeros((2, 9))),
        lambda: displace(road, s, np.zeros((2, 10, 3))),
        lambda: displace(road, s, np.zeros(())),
        lambda: displace(sample(road, s), s, np.zeros((2, 9, 2))),
        lambda: displace(road, s, np.full((2, 10), np.nan)),
        lambda: displace(road, s[::-1], np.zeros((2, 10))),
        lambda: CurveBatch(s, np.zeros((3, 9, 2))),
        lambda: CurveBatch(s[:2], np.zeros((3, 2, 2))).heading,
    ):
        with pytest.raises(GeometryError):
            call()


def test_a_line_that_is_moved_again_and_again_knows_its_direction_without_angles() -> None:
    road = circle(radius=60.0, count=200)
    s = road.stations(count=201)
    lines: CurveBatch = displace(road, s, np.zeros((2, 201)))
    for number in range(1, 4):
        lines = displace(lines, s, [[2.0], [-3.0]] * np.sin(2 * np.pi * number * s / road.length))
        np.testing.assert_allclose(lines.toward_east, np.cos(lines.heading), atol=1e-12)
        np.testing.assert_allclose(lines.toward_north, np.sin(lines.heading), atol=1e-12)
