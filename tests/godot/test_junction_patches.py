"""Junctions: strips are cut back until none overlaps, and the patch joins their ends."""

from __future__ import annotations

import math

import cv2
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from roadlang_godot.build.frame import SceneOrigin
from roadlang_godot.build.junctions import MARGIN, RoadArm, cuts, order, patch
from roadlang_godot.build.layout import layout_of
from roadlang_godot.build.line import line_of, polyline
from roadlang_godot.build.road_mesh import road_parts
from roadlang_godot.net.protocol import Message
from tests.godot.godot_scenes import pieces, road, scene, straight, town
from tests.godot.test_road_mesh import strip

PIXEL = 0.08
bearings = st.lists(st.integers(0, 35), min_size=2, max_size=5, unique=True)


def star(degrees: list[int]) -> list[RoadArm]:
    """Arms of 80 m that leave the origin."""
    return order(
        [
            RoadArm(line_of(road(f"{d}", pieces(straight(80), heading=math.radians(d)))), 1)
            for d in degrees
        ]
    )


def painted(polygons: list[np.ndarray]) -> np.ndarray:
    """How many polygons cover each 8 cm of the square around the origin."""
    count = np.zeros((800, 800), np.uint8)
    for polygon in polygons:
        layer = np.zeros(count.shape, np.uint8)
        cv2.fillPoly(layer, [np.round(polygon / PIXEL + 400).astype(np.int32)], 1)
        count += layer
    return count


def strips_of(arms: list[RoadArm], back: list[float]) -> list[np.ndarray]:
    out = []
    for arm, cut in zip(arms, back, strict=True):
        near = [strip(t) for t in road_parts(arm.line, 1, SceneOrigin(), cut, 30.0)]
        edges = np.concatenate(near)
        out.append(np.concatenate([edges[:, 0], edges[::-1, 1]])[:, [0, 2]])
    return out


@settings(max_examples=20)
@given(bearings)
def test_no_two_roads_overlap_after_the_cut(tens: list[int]) -> None:
    degrees = sorted(10 * one for one in tens)
    gaps = [(b - a) % 360 for a, b in zip(degrees, degrees[1:] + degrees[:1], strict=True)]
    assume(min(gaps) >= 30)
    arms = star(degrees)
    covered = painted(strips_of(arms, cuts(arms)))
    # Outlines are drawn with their rims, so neighbors may share a line of pixels.
    assert (cv2.erode((covered > 1).astype(np.uint8), np.ones((4, 4), np.uint8)) == 0).all()


def test_the_patch_has_the_very_corners_of_the_roads() -> None:
    arms = star([0, 90, 200])
    back = cuts(arms)
    made = patch(arms, back, 1, SceneOrigin(), "here")
    head = np.frombuffer(made.body[:2], "<u2")[0]
    corners = {tuple(p) for p in np.frombuffer(made.body[4:], "<f4", int(head) * 3).reshape(-1, 3)}
    for arm, cut in zip(arms, back, strict=True):
        first = strip(road_parts(arm.line, 1, SceneOrigin(), cut, 30.0)[0])[0]
        assert {tuple(first[0]), tuple(first[1])} <= corners


def test_patch_and_roads_leave_no_hole_in_a_crossing() -> None:
    arms = star([0, 80, 180, 260])
    back = cuts(arms)
    made = patch(arms, back, 1, SceneOrigin(), "here")
    count = int(np.frombuffer(made.body[:2], "<u2")[0])
    ring = np.frombuffer(made.body[4:], "<f4", count * 3).reshape(-1, 3)[1:, [0, 2]]
    covered = painted([ring, *strips_of(arms, back)]) > 0
    for degrees in (0, 80, 180, 260):
        turn = math.radians(degrees)
        for along in np.arange(0, 29, 0.5):
            x = round((along * math.cos(turn)) / PIXEL + 400)
            y = round((-along * math.sin(turn)) / PIXEL + 400)
            assert covered[y, x]


def test_corners_of_a_patch_are_quadratic_curves_between_the_edges() -> None:
    """Between two cuts: control point where the edges meet, equal steps of the parameter."""
    arms = star([0, 80, 170, 260])
    made = patch(arms, [12.0, 9.0, 11.0, 10.0], 1, SceneOrigin(), "here")
    count = int(np.frombuffer(made.body[:2], "<u2")[0])
    ring = np.frombuffer(made.body[4:], "<f4", count * 3).reshape(-1, 3)[1:, [0, 2]] * [1, -1]
    corners = ring.reshape(4, -1, 2)  # right and left corner of an arm, then the curve to the next
    assert corners.shape[1] == 2 + 5
    for here, after in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        start, end = here[1], after[0]
        along, across = start - here[0], end - after[1]  # each at right angles to its edge
        bend = np.linalg.solve([along, across], [along @ start, across @ end])
        t = np.arange(1, 6)[:, None] / 6
        curve = (1 - t) ** 2 * start + 2 * t * (1 - t) * bend + t**2 * end
        np.testing.assert_allclose(here[2:], curve, atol=1e-4)


def test_a_town_gets_a_patch_for_each_node_where_roads_meet() -> None:
    roads, network = town()
    things = layout_of(scene(*roads, networks=[network])).parts
    labels = [thing.label for thing in things if thing.kind == Message.PATCH]
    assert labels == ["junction 1 of town", "junction 2 of town"]


@pytest.mark.parametrize("degrees", [40.0, 60.0, 90.0, 120.0, 150.0])
@pytest.mark.parametrize("widths", [(4.0, 10.0), (10.0, 4.0), (7.0, 7.0)])
def test_roads_of_two_widths_are_cut_where_their_edges_meet(
    degrees: float, widths: tuple[float, float]
) -> None:
    """The left edge of the one and the right edge of the other, seen from the node."""
    turn = math.radians(degrees)
    ends = np.array([[100.0, 0.0], [100.0 * math.cos(turn), 100.0 * math.sin(turn)]])
    one, other = (
        RoadArm(polyline(name, np.linspace([0.0, 0.0], end, 101), width), 1)
        for name, end, width in zip("ab", ends, widths, strict=True)
    )
    first, second = cuts([one, other])
    _, left = one.corners(first - MARGIN)
    right, _ = other.corners(second - MARGIN)
    if min(first, second) > MARGIN and max(first, second) < 40.0:
        np.testing.assert_allclose(left, right, atol=1e-6)
    else:
        assert degrees > 90
