"""Ends of roads in clean pictures: where they are, and which short ones are roads."""

from __future__ import annotations

import math

import cv2
import numpy as np
import pytest

from roadlang.geometry import Floats
from roadlang_standard.extraction.drawings.surface_roads import roads_of_surface
from roadlang_standard.extraction.graphs.graph import Graph
from roadlang_standard.extraction.graphs.square_stubs import add_square_stubs, square_ends

FRACTION = 4
"""Bits of a pixel in which OpenCV draws."""


def _drawn(start: Floats, end: Floats, width: int, round_pen: bool) -> Floats:
    """A straight stroke (300, 300), 0..1."""
    surface = np.zeros((300, 300), np.uint8)
    corners = np.array([start, end])
    if not round_pen:
        ahead = (end - start) / np.hypot(*(end - start))
        side = np.array([-ahead[1], ahead[0]]) * width / 2
        corners = np.array([start + side, end + side, end - side, start - side])
    fixed = np.round(corners * 2**FRACTION).astype(np.int32)
    if round_pen:
        first, last = (tuple(map(int, corner)) for corner in fixed)
        cv2.line(surface, first, last, 255, width, cv2.LINE_AA, FRACTION)
    else:
        cv2.fillPoly(surface, [fixed], 255, cv2.LINE_AA, FRACTION)
    return surface / 255.0


@pytest.mark.parametrize("round_pen", [True, False], ids=["round pen", "cut off straight"])
@pytest.mark.parametrize("width", [7, 16, 24])
@pytest.mark.parametrize("degrees", [0, 13, 45])
def test_roads_end_where_they_were_drawn_to(round_pen: bool, width: int, degrees: int) -> None:
    """A round pen draws half a width beyond the end of its road."""
    ahead = np.array([math.cos(math.radians(degrees)), math.sin(math.radians(degrees))])
    start, end = 150 - 90 * ahead, 150 + 90 * ahead
    (road,) = roads_of_surface(
        _drawn(start, end, width, round_pen).astype(np.float32), "stroke"
    ).roads
    along = sorted(float(ahead @ (point - 150)) for point in (road.points[0], road.points[-1]))
    assert along == pytest.approx([-90, 90], abs=3.0)


def test_a_stub_is_a_road_and_a_corner_is_none() -> None:
    """A crossing street, 20 px wide, of which 18 px show on one side of the road."""
    surface = np.zeros((120, 200), np.float32)
    surface[50:70, 10:190] = 1
    surface[32:50, 90:110] = 1
    found = roads_of_surface(surface, "plan")
    assert len(found.roads) == 3
    ends = {tuple(np.round(found.nodes[n])) for road in found.roads for n in (road.start, road.end)}
    assert any(abs(x - 99.5) <= 2 and abs(y - 32) <= 2 for x, y in ends)


@pytest.mark.parametrize(("below", "roads"), [(14, 4), (2, 3)], ids=["a street", "a bay"])
def test_a_stub_without_a_line_in_the_skeleton_is_a_road(below: int, roads: int) -> None:
    """A crossing with rounded corners, roads 16 px wide: below, little shows beyond them."""
    surface = np.zeros((140, 200), np.float32)
    surface[60:76, 10:190] = surface[10:76, 92:108] = 1
    surface[76 : 76 + below, 92:108] = 1
    for side, corner in ((-1, 91), (1, 108)):
        for step in range(7):
            surface[76 + step, corner : corner + side * (7 - step) : side] = 1 if below > 7 else 0
    found = roads_of_surface(surface, "plan")
    assert len(found.roads) == roads
    lowest = max(float(point[1]) for road in found.roads for point in road.points)
    assert lowest == pytest.approx(90.0 if below > 7 else 68.0, abs=2.5)


def test_ends_that_no_line_is_ahead_of_begin_no_road() -> None:
    mask = np.zeros((80, 160), bool)
    mask[32:48, 40:120] = True
    assert len(list(square_ends(mask, 16.0))) == 2
    graph = Graph()
    assert add_square_stubs(graph, mask, 16.0) == []
    assert not graph.lines
