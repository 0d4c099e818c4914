"""Many variants of a curve at once."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import (
    Curve,
    CurveBatch,
    DisplacedBatch,
    Frame,
    GeometryError,
    displace,
    heading_error,
    sample,
)
from tests.geometry.geometry_shapes import circle, curves, line, walks, wave


def sine(stations: Any, amplitude: Any, wavelength: Any) -> Any:
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


def test_a_sine_on_a_straight_has_the_curvature_of_the_sine() -> None:
    road = line(200.0)
    s = road.stations(count=500)
    value, slope, bend = sine(s, 4.0, 60.0)
    exact = bend / (1 + slope**2) ** 1.5
    given_derivatives = displace(road, s, value[None], slope[None], bend[None])
    np.testing.assert_allclose(given_derivatives.curvature[0], exact, atol=1e-14)
    np.testing.assert_allclose(given_derivatives.heading[0], np.arctan(slope), atol=1e-14)
    np.testing.assert_allclose(displace(road, s, value).curvature[0], exact, atol=3e-4)


@given(walks(smallest=3), st.floats(-2.0, 2.0), st.floats(30.0, 90.0))
def test_frenet_agrees_with_the_spline_through_the_displaced_points(
    points: Any, amplitude: float, wavelength: float
) -> None:
    road = Curve.through(points).resampled(spacing=1.0)
    s = road.stations(spacing=0.25)
    value, slope, bend = sine(s, amplitude, wavelength)
    batch = displace(road, s, value, slope, bend)
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
def test_differences_converge_with_the_square_of_the_gap(closed: bool) -> None:
    road = circle(radius=30.0, count=600) if closed else wave()

    def error(count: Any) -> Any:
        s = road.stations(count=count)
        wavelength = road.length / 4
        exact = displace(road, s, *sine(s, 2.0, wavelength))
        rough = displace(road, s, sine(s, 2.0, wavelength)[0])
        return np.abs(exact.curvature - rough.curvature).max()

    assert error(400) < error(200) / 3.0
    assert error(200) < 1e-3


def test_curvature_from_points_alone_agrees_with_frenet() -> None:
    road = wave()
    s = road.stations(count=400)
    exact = displace(road, s, *sine(s, 3.0, 70.0))
    points = CurveBatch(s, exact.points)
    np.testing.assert_allclose(points.curvature, exact.curvature, atol=2e-3)
    np.testing.assert_allclose(points.heading, exact.heading, atol=2e-3)


def test_uneven_stations_are_allowed() -> None:
    road = line(100.0)
    s = np.cumsum(np.tile([0.1, 0.3], 200))
    value, _, _ = sine(s, 2.0, 50.0)
    exact = displace(road, s, *sine(s, 2.0, 50.0))
    np.testing.assert_allclose(displace(road, s, value).curvature, exact.curvature, atol=5e-3)


def test_a_displacement_past_the_center_of_a_bend_is_folded() -> None:
    ring = circle(radius=10.0)
    s = ring.stations(count=100)
    moves = np.array([[9.0], [11.0], [-50.0]]) * np.ones((3, 100))
    np.testing.assert_array_equal(displace(ring, s, moves).folded, [False, True, False])


@given(curves())
def test_no_displacement_is_the_curve_itself(curve: Any) -> None:
    s = curve.stations(count=60)
    batch = sample(curve, s)
    np.testing.assert_array_equal(batch.points[0], curve.at(s))
    np.testing.assert_allclose(batch.curvature[0], curve.curvature(s), atol=1e-12, rtol=1e-12)
    np.testing.assert_array_equal(batch.heading[0], curve.heading(s))
    assert not batch.folded.any()


def test_displacements_add_up_when_a_batch_is_displaced_again() -> None:
    road = line(50.0)
    s = road.stations(count=51)
    twice = displace(displace(road, s, np.full((2, 51), 1.0)), s, np.full((2, 51), 2.0))
    np.testing.assert_allclose(twice.points[..., 1], 3.0)


def test_taking_variants_keeps_what_is_exact() -> None:
    road = wave()
    s = road.stations(count=50)
    value, slope, bend = (np.stack([a, 2 * a, 3 * a]) for a in sine(s, 1.0, 50.0))
    batch = displace(Frame.of(road, s), s, value, slope, bend)
    chosen = batch.take(np.array([True, False, True]))
    assert isinstance(chosen, DisplacedBatch)
    np.testing.assert_array_equal(chosen.curvature, batch.curvature[[0, 2]])


def test_rows_do_not_depend_on_their_neighbors() -> None:
    road = wave()
    s = road.stations(count=333)
    moves = np.random.default_rng(0).normal(size=(100, 333))
    together = displace(road, s, moves)
    alone = displace(road, s, moves[77:78])
    for name in ("points", "heading", "curvature", "folded"):
        np.testing.assert_array_equal(getattr(together, name)[77:78], getattr(alone, name))


def test_heading_error_is_wrapped() -> None:
    s = line().stations(count=5)
    there = sample(line(), s)
    back = CurveBatch(s, -there.points)
    np.testing.assert_allclose(np.abs(heading_error(there, back)), np.pi)


def test_shapes_that_do_not_fit_are_refused() -> None:
    road = line()
    s = road.stations(count=10)
    for call in (
        lambda: displace(road, s, np.zeros((2, 9))),
        lambda: displace(road, s, np.full((2, 10), np.nan)),
        lambda: displace(road, s[::-1], np.zeros((2, 10))),
        lambda: CurveBatch(s, np.zeros((3, 9, 2))),
        lambda: CurveBatch(s[:2], np.zeros((3, 2, 2))).heading,
    ):
        with pytest.raises(GeometryError):
            call()
