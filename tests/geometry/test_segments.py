"""Roads drawn from straights, arcs and clothoids."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import Arc, Clothoid, GeometryError, Straight, chain

pieces = st.one_of(
    st.builds(Straight, st.floats(1.0, 80.0)),
    st.builds(Arc, st.floats(5.0, 80.0), st.floats(0.05, 3.0) | st.floats(-3.0, -0.05)),
    st.builds(Clothoid, st.floats(5.0, 80.0), st.floats(-0.1, 0.1), st.floats(-0.1, 0.1)),
)


def test_a_straight_an_arc_and_a_straight_end_where_they_should() -> None:
    road = chain([Straight(10.0), Arc(5.0, np.pi / 2), Straight(10.0)])
    np.testing.assert_allclose(road.points[-1], (15.0, 15.0), atol=1e-13)
    assert road.heading[-1] == pytest.approx(np.pi / 2)
    assert road.stations[-1] == pytest.approx(20.0 + 2.5 * np.pi)


def test_a_negative_angle_bends_right() -> None:
    road = chain([Arc(5.0, -np.pi)], start=(1.0, 2.0), heading=np.pi / 2)
    np.testing.assert_allclose(road.points[-1], (11.0, 2.0), atol=1e-13)
    np.testing.assert_allclose(road.curvature, -0.2)


def test_a_clothoid_is_the_fresnel_integral() -> None:
    from scipy.special import fresnel

    length, curvature = 60.0, 0.08
    road = chain([Clothoid(length, 0.0, curvature)])
    scale = np.sqrt(np.pi * length / curvature)
    y, x = fresnel(road.stations / scale)
    np.testing.assert_allclose(road.points, scale * np.stack([x, y], axis=1), atol=1e-12)
    np.testing.assert_allclose(road.curvature, curvature * road.stations / length)


@given(st.lists(pieces, min_size=1, max_size=5), st.floats(-3.0, 3.0))
def test_length_and_heading_add_up_whatever_the_spacing(segments: Any, heading: float) -> None:
    coarse = chain(segments, heading=heading, spacing=20.0)
    fine = chain(segments, heading=heading, spacing=0.5)
    turned = sum(piece.length * sum(piece.curvatures) / 2 for piece in segments)
    assert fine.stations[-1] == pytest.approx(sum(piece.length for piece in segments))
    assert fine.heading[-1] == pytest.approx(heading + turned, abs=1e-9)
    np.testing.assert_allclose(coarse.points[-1], fine.points[-1], atol=1e-9)


@given(st.lists(pieces, min_size=1, max_size=5))
def test_the_curve_has_the_chain_s_length_headings_and_curvatures(segments: Any) -> None:
    road = chain(segments)
    curve = road.curve()
    assert curve.length == pytest.approx(road.stations[-1], rel=1e-6)
    inner = (road.stations[1:] + road.stations[:-1]) / 2
    np.testing.assert_allclose(curve.at(road.stations), road.points, atol=1e-3)
    np.testing.assert_allclose(curve.heading(road.stations), road.heading, atol=1e-3)
    between = np.sort(np.stack([road.curvature[1:], road.curvature[:-1]]), axis=0)
    # At a joint the samples have the curvature of the piece ahead, not that of the one that ends.
    joints = np.cumsum([piece.length for piece in segments])
    jump = (np.abs(road.stations[1:, None] - joints) < 1e-6).any(axis=1)
    curvature = curve.curvature(inner)
    assert (curvature >= between[0] - 2e-3)[~jump].all()
    assert (curvature <= between[1] + 2e-3)[~jump].all()


def test_a_ring_of_pieces_closes() -> None:
    half: list[Straight | Arc] = [Straight(30.0), Arc(10.0, np.pi)]
    oval = half + half
    curve = chain(oval).curve(closed=True)
    assert curve.closed
    assert curve.length == pytest.approx(60.0 + 20.0 * np.pi, rel=1e-8)
    with pytest.raises(GeometryError, match="do not close"):
        chain(oval[:3]).curve(closed=True)


@pytest.mark.parametrize(
    "segments",
    [
        [],
        [Straight(0.0)],
        [Straight(-5.0)],
        [Straight(float("nan"))],
        [Arc(0.0, 1.0)],
        [Arc(-5.0, 1.0)],
        [Arc(5.0, 0.0)],
        [Clothoid(10.0, 0.0, float("inf"))],
        [Clothoid(1e9, 0.0, 1.0)],
        [Straight(1e13)],
    ],
)
def test_impossible_pieces_are_refused(segments: Any) -> None:
    with pytest.raises(GeometryError):
        chain(segments)
