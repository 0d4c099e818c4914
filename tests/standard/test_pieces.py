"""The pieces that roads are drawn from: their lengths, and where each leads."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from roadlang_standard.draw_segments import Segments
from roadlang_standard.draw_waypoints import Waypoints
from roadlang_standard.pieces import ArcPiece, ClothoidPiece, StraightPiece

PIECES = [
    (StraightPiece(80.0), 80.0),
    (ArcPiece(50.0, math.pi / 2), 50 * math.pi / 2),
    (ArcPiece(50.0, -math.pi / 2), 50 * math.pi / 2),
    (ClothoidPiece(30.0, to=0.02), 30.0),
]


@pytest.mark.parametrize(("piece", "length"), PIECES)
def test_a_piece_is_at_least_as_long_as_it_says(piece: Any, length: float) -> None:
    assert piece.least_length() == pytest.approx(length)
    drawn = Segments((piece,)).draw(False)
    assert drawn.length == pytest.approx(length, rel=1e-3)
    assert Segments((piece,)).least_length() <= drawn.length


@pytest.mark.parametrize(("angle", "end"), [(math.pi / 2, (50, 50)), (-math.pi / 2, (50, -50))])
def test_an_arc_turns_left_by_a_positive_angle(angle: float, end: tuple[float, float]) -> None:
    curve = Segments((ArcPiece(50.0, angle),)).draw(False)
    np.testing.assert_allclose(curve.at(curve.length), end, atol=0.05)
    assert curve.curvature(curve.length / 2) == pytest.approx(
        math.copysign(1 / 50, angle), rel=1e-2
    )


def test_a_clothoid_goes_on_with_the_curvature_before_it() -> None:
    curve = Segments((ArcPiece(50.0, 1.0), ClothoidPiece(40.0, to=0.0), StraightPiece(20.0))).draw(
        False
    )
    assert curve.curvature(50.0 + 20.0) == pytest.approx(0.01, rel=0.05)


def test_where_a_road_begins_and_points() -> None:
    curve = Segments((StraightPiece(10.0),), start=(5.0, -3.0), heading=math.pi / 2).draw(False)
    np.testing.assert_allclose(curve.at(np.array([0.0, 10.0])), [[5, -3], [5, 7]], atol=1e-9)


@pytest.mark.parametrize("curve", ["spline", "polyline"])
def test_waypoints_are_at_least_as_long_as_they_say(curve: str) -> None:
    bent = Waypoints(((0.0, 0.0), (60.0, 30.0), (100.0, 0.0)), curve, 20.0)
    straight = math.dist((0, 0), (60, 30)) + math.dist((60, 30), (100, 0))
    length = bent.draw(False).length
    assert bent.least_length() <= length
    assert length > straight if curve == "spline" else length < straight
