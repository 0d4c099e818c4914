"""Curves by arc length."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from roadlang.geometry import Curve, CurveFrame, GeometryError
from roadlang.geometry.curves.arclength import ArcLength
from tests.geometry.geometry_shapes import (
    angles,
    circle,
    curves,
    line,
    rotation,
    shifts,
    walks,
    wave,
)


def test_two_points_make_a_straight_line() -> None:
    curve = Curve.through([(1.0, 2.0), (4.0, 6.0)])
    assert curve.length == pytest.approx(5.0, rel=1e-15)
    np.testing.assert_allclose(curve.at([0.0, 2.5, 5.0]), [(1, 2), (2.5, 4), (4, 6)], atol=1e-14)
    np.testing.assert_array_equal(curve.curvature([0.0, 1.0, 5.0]), 0.0)
    np.testing.assert_allclose(curve.heading([0.0, 5.0]), np.arctan2(4, 3))


def test_a_circle_has_its_circumference_and_curvature() -> None:
    curve = circle(radius=20.0, count=128)
    s = curve.stations(count=777)
    assert curve.length == pytest.approx(40.0 * np.pi, rel=1e-8)
    np.testing.assert_allclose(curve.curvature(s), 1 / 20, rtol=3e-4)
    np.testing.assert_allclose(np.linalg.norm(curve.at(s), axis=1), 20.0, rtol=1e-7)


def test_a_circle_run_clockwise_has_negative_curvature() -> None:
    assert (circle().reversed().curvature(np.linspace(0, 60, 50)) < -0.09).all()


def test_a_closed_curve_goes_round() -> None:
    curve = circle()
    s = np.linspace(-30.0, 130.0, 99)
    np.testing.assert_allclose(curve.at(s + curve.length), curve.at(s), atol=1e-9)
    np.testing.assert_allclose(curve.curvature(s + curve.length), curve.curvature(s), atol=1e-9)
    np.testing.assert_allclose(curve.heading(s + curve.length), curve.heading(s) + 2 * np.pi)


def test_an_open_curve_goes_straight_on_beyond_its_ends() -> None:
    curve = wave()
    for end, beyond in ((0.0, -7.0), (curve.length, curve.length + 7.0)):
        step = curve.at(beyond) - curve.at(end)
        np.testing.assert_allclose(step, (beyond - end) * curve.tangent(end), atol=1e-9)
        assert curve.heading(beyond) == curve.heading(end)
        assert curve.curvature(beyond) == 0.0


@given(curves())
def test_the_parameter_is_the_arc_length(curve: Any) -> None:
    s = np.linspace(1.0, curve.length - 1.0, 200)
    fastest = np.linalg.norm(curve.at(s + 1e-4) - curve.at(s - 1e-4), axis=1) / 2e-4
    np.testing.assert_allclose(fastest, 1.0, atol=1e-6)
    fine = curve.at(np.linspace(0.0, curve.length, 5_000))
    chords = np.linalg.norm(np.diff(fine, axis=0), axis=1).sum()
    assert chords == pytest.approx(curve.length, rel=1e-5)


@given(walks())
def test_the_curve_passes_through_its_points_and_ends_exactly_there(points: Any) -> None:
    curve = Curve.through(points)
    s, offset = curve.project(points)
    np.testing.assert_allclose(curve.at(s), points, atol=1e-9)
    np.testing.assert_allclose(offset, 0.0, atol=1e-9)
    np.testing.assert_array_equal(curve.at([0.0, curve.length]), points[[0, -1]])


@given(curves())
def test_heading_and_curvature_are_the_derivatives_of_position_and_heading(curve: Any) -> None:
    s = np.linspace(0.5, curve.length - 0.5, 101)
    h = 1e-4
    chord = (curve.at(s + h) - curve.at(s - h)) / (2 * h)
    turn = (curve.heading(s + h) - curve.heading(s - h)) / (2 * h)
    heading = curve.heading(s)
    np.testing.assert_allclose(chord, np.stack([np.cos(heading), np.sin(heading)], 1), atol=1e-5)
    curvature = curve.curvature(s)
    slope = np.abs(curve.curvature(s + h) - curve.curvature(s - h)).max() / (2 * h)
    np.testing.assert_allclose(turn, curvature, atol=1e-3 * (1 + slope))


@given(curves(), angles, shifts)
def test_turning_and_moving_the_points_turns_and_moves_the_curve(
    plain: Any, angle: Any, shift: Any
) -> None:
    moved = Curve.through(plain.points @ rotation(angle).T + shift, plain.closed)
    s = plain.stations(count=50)
    assert moved.length == pytest.approx(plain.length, rel=1e-8)
    np.testing.assert_allclose(moved.at(s), plain.at(s) @ rotation(angle).T + shift, atol=1e-5)
    np.testing.assert_allclose(moved.curvature(s), plain.curvature(s), atol=1e-5, rtol=1e-4)


@given(curves(), st.floats(1e-3, 1e3))
def test_scaling_scales_lengths_and_divides_curvature(plain: Any, factor: float) -> None:
    scaled = plain.scaled(factor)
    s = plain.stations(count=50)
    assert scaled.length == pytest.approx(plain.length * factor, rel=1e-9)
    np.testing.assert_allclose(
        scaled.curvature(s * factor) * factor, plain.curvature(s), atol=1e-7, rtol=1e-6
    )


@given(curves())
def test_reversing_twice_changes_nothing(curve: Any) -> None:
    s = curve.stations(count=40)
    back = curve.reversed()
    np.testing.assert_allclose(back.at(curve.length - s), curve.at(s), atol=1e-8)
    np.testing.assert_allclose(back.reversed().at(s), curve.at(s), atol=1e-8)
    np.testing.assert_allclose(back.points[0], curve.points[0 if curve.closed else -1])


@given(curves(), st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_a_part_is_the_same_curve(curve: Any, a: float, b: float) -> None:
    start, stop = a * curve.length, b * curve.length
    span = (stop - start) % curve.length if curve.closed else stop - start
    assume(0.1 < span < curve.length - 0.1)
    part = curve.between(start, stop)
    s = np.linspace(0.0, span, 50)
    assert part.length == pytest.approx(span, rel=1e-8)
    np.testing.assert_allclose(part.at(s), curve.at(start + s), atol=1e-7)
    np.testing.assert_allclose(part.curvature(s[1:-1]), curve.curvature(start + s[1:-1]), atol=1e-6)


def test_a_whole_lap_from_any_place_is_an_open_curve() -> None:
    ring = circle()
    lap = ring.between(0.0, ring.length)
    assert not lap.closed
    assert lap.length == pytest.approx(ring.length)
    np.testing.assert_allclose(lap.at(lap.length), lap.at(0.0), atol=1e-9)


def test_resampling_keeps_the_shape() -> None:
    curve = wave()
    again = curve.resampled(spacing=2.0)
    s = curve.stations(count=99)
    assert again.length == pytest.approx(curve.length, abs=1e-4)
    np.testing.assert_allclose(again.at(s), curve.at(s), atol=1e-3)


def test_stations_of_an_open_curve_include_both_ends_those_of_a_ring_only_the_start() -> None:
    np.testing.assert_array_equal(line(10.0).stations(spacing=3.0), [0.0, 2.5, 5.0, 7.5, 10.0])
    ring = circle()
    s = ring.stations(count=4)
    np.testing.assert_allclose(s, ring.length * np.array([0.0, 0.25, 0.5, 0.75]))


def test_uneven_points_of_a_circle_are_as_good_as_even_ones() -> None:
    angle = np.cumsum(np.tile([0.05, 0.15], 32)) * np.pi / 3.2
    curve = Curve.through(10 * np.stack([np.cos(angle), np.sin(angle)], axis=1), closed=True)
    np.testing.assert_allclose(curve.curvature(curve.stations(count=500)), 0.1, rtol=3e-3)


def test_repeated_points_count_once() -> None:
    once = Curve.through([(0, 0), (5, 1), (9, 4)])
    repeated = Curve.through([(0, 0), (0, 0), (5, 1), (5, 1), (5, 1), (9, 4), (9, 4)])
    np.testing.assert_array_equal(repeated.points, once.points)
    closed = Curve.through([(0, 0), (5, 1), (9, 4), (0, 0)], closed=True)
    assert len(closed.points) == 3


@pytest.mark.parametrize("size", [1e-9, 1e-6, 1e6])
def test_tiny_and_huge_curves_are_like_any_other(size: float) -> None:
    curve = circle(radius=size)
    assert curve.length == pytest.approx(2 * np.pi * size, rel=1e-6)
    np.testing.assert_allclose(
        curve.curvature(np.linspace(0, curve.length, 9)) * size, 1, rtol=2e-3
    )


def test_rough_points_still_make_a_finite_curve() -> None:
    rng = np.random.default_rng(5)
    for closed in (False, True):
        points = rng.uniform(-10, 10, (40, 2))
        curve = Curve.through(points, closed)
        s = curve.stations(count=1000)
        assert np.isfinite(curve.curvature(s)).all()
        np.testing.assert_allclose(curve.at(curve.project(points)[0]), points, atol=1e-8)


def test_there_and_back_on_a_line_stays_finite() -> None:
    curve = Curve.through([(0, 0), (10, 0), (20, 0)], closed=True)
    s = curve.stations(count=101)
    assert np.isfinite(curve.at(s)).all()
    assert np.isfinite(curve.curvature(s)).all()


@pytest.mark.parametrize(
    ("points", "closed", "message"),
    [
        ([], False, "at least 2 distinct points, not 0"),
        ([(1, 1)], False, "at least 2 distinct points, not 1"),
        ([(1, 1), (1, 1)], False, "at least 2 distinct points, not 1"),
        ([(1, 1), (2, 2), (1, 1)], True, "at least 3 distinct points, not 2"),
        ([(0, 0), (1, float("nan"))], False, "finite"),
        ([(0, 0), (1, float("inf"))], False, "finite"),
        ([(0, 0), (1e300, 1e300)], False, "within"),
        ([(0, 0, 0), (1, 1, 1)], False, "pairs"),
        ("road", False, "numbers"),
    ],
)
def test_what_is_no_curve_is_refused_in_plain_words(
    points: Any, closed: bool, message: str
) -> None:
    with pytest.raises(GeometryError, match=message):
        Curve.through(points, closed)


def test_refusals_of_the_other_methods() -> None:
    curve = line()
    for call in (
        lambda: curve.at(float("nan")),
        lambda: curve.stations(),
        lambda: curve.stations(spacing=0.0),
        lambda: curve.stations(count=1),
        lambda: curve.between(5.0, 5.0),
        lambda: curve.project([1.0, 2.0, 3.0]),
        lambda: curve.scaled(0.0),
        lambda: Curve.hermite([(0, 0), (1, 0)], [0.0]),
    ):
        with pytest.raises(GeometryError):
            call()


@pytest.mark.parametrize("closed", [False, True])
def test_a_frame_finds_its_places_once(closed: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    curve = Curve.through([(0.0, 0.0), (30.0, 5.0), (50.0, 40.0), (10.0, 60.0)], closed)
    s = np.linspace(-5.0, curve.length + 5.0, 60)
    curvature, slope = curve.bending(s)
    apart = curve.at(s), curve.heading(s), curvature, slope
    found: list[int] = []
    parameter = ArcLength.parameter

    def counted(self: ArcLength, s: Any) -> Any:
        found.append(len(s))
        return parameter(self, s)

    monkeypatch.setattr(ArcLength, "parameter", counted)
    for together, alone in zip(curve.pose_and_bending(s), apart, strict=True):
        np.testing.assert_array_equal(together, alone)
    CurveFrame.of(curve, curve.stations(1.0))
    assert found == [60, len(curve.stations(1.0))]
