"""A picture of a scene from above, around the agent that is driven: `render_mode="rgb_array"`."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..drive.lane_bands import bands_and_lines, lane_bands
from ..drive.lane_lines import painted_lines, shown_part
from ..drive.road_areas import road_areas
from ..drive.robustness_colors import OTHER
from ..geometry.arrays import Booleans, Floats
from ..geometry.lanes.strokes_of_lanes import LaneStroke
from ..ir.category import GREENERY
from ..ir.scene import Scene, SceneActor
from ..scenes.figure_colors import FIGURE_COLORS, object_color
from ..scenes.shown_junctions import shown_junctions

PIXELS = 480
"""width and height of a picture; even, as encoders of clips want it"""
SCALE = 6.0
"""pixels for each meter: 80 m are seen"""
_DRIVEN = "#c92a2a"
_WINDSHIELD = "#23272b"
_FRACTION_BITS = 4
"""of the places of corners within a pixel"""

Picture = NDArray[np.uint8]


@dataclass(frozen=True, eq=False)
class _Shape:
    """An area (n, 2) in meters, or the line through its points where it has a width, in pixels."""

    points: Floats
    color: str
    width: float = 0.0


class TopView:
    """Draws one scene again and again: what does not move is prepared once. North is up."""

    def __init__(self, scene: Scene, driven: int) -> None:
        self._agents = scene.agents
        self._driven = driven
        self._still = [*_road_shapes(scene), *map(_object_shape, scene.objects)]
        self._boxes = [(s.points.min(axis=0), s.points.max(axis=0)) for s in self._still]

    def picture(self, x: Floats, y: Floats, heading: Floats, present: Booleans) -> Picture:
        """(PIXELS, PIXELS, 3) RGB, of agents (A,) in the order of the scene."""
        middle = np.array([x[self._driven], y[self._driven]])
        reach = 0.5 * PIXELS / SCALE
        pixels = np.full((PIXELS, PIXELS, 3), _rgb(FIGURE_COLORS.ground), np.uint8)

        def place(points: Floats) -> Floats:
            return np.asarray((points - middle) * (SCALE, -SCALE) + 0.5 * PIXELS)

        for shape, (low, high) in zip(self._still, self._boxes, strict=True):
            if (high >= middle - reach).all() and (low <= middle + reach).all():
                _draw(pixels, shape, place)
        for index, agent in enumerate(self._agents):
            if not present[index]:
                continue
            color = _DRIVEN if index == self._driven else OTHER
            pose = (float(x[index]), float(y[index]), float(heading[index]))
            for shape in _vehicle_shapes(agent, pose, color):
                _draw(pixels, shape, place)
        return pixels


def _road_shapes(scene: Scene) -> Iterator[_Shape]:
    """From the ground up: areas, then lines."""
    roads = [road for road in scene.roads if road.derived] or list(scene.roads)
    parts = [part for road in roads if (part := shown_part(road)) is not None]
    painted = [found for part in parts for found in painted_lines(part, SCALE)]
    every = [band for part in parts for band in lane_bands(part)]
    bands, lines = bands_and_lines(every, [line for line, _ in painted])
    junctions = shown_junctions(scene, {road.name for road in roads})
    for area in road_areas(bands, junctions, {road.name: road for road in scene.roads}):
        yield _Shape(area.ring, area.color)
    for line, (_, stroke) in zip(lines, painted, strict=True):
        yield from _line_shapes(line, stroke)


def _line_shapes(line: Floats, stroke: LaneStroke) -> Iterator[_Shape]:
    """A line, or the dashes of a broken one."""
    color = FIGURE_COLORS.curb if stroke.is_curb else FIGURE_COLORS.marking
    if stroke.dashes is None:
        yield _Shape(line, color, stroke.width)
        return
    drawn, gap = (part / SCALE for part in stroke.dashes)
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])
    for start in np.arange(0.0, along[-1], drawn + gap):
        s = np.array([start, min(start + drawn, along[-1])])
        ends = np.column_stack([np.interp(s, along, column) for column in line.T])
        yield _Shape(ends, color, stroke.width)


def _object_shape(found: SceneActor) -> _Shape:
    size = (found.length, found.width)
    if found.category in GREENERY:
        angle = np.linspace(0.0, 2.0 * np.pi, 16, endpoint=False)
        crown = 0.5 * max(size) * np.column_stack([np.cos(angle), np.sin(angle)])
        return _Shape(crown + np.array([found.x, found.y]), object_color(found.category))
    return _Shape(_box(size, (found.x, found.y, found.heading)), object_color(found.category))


def _vehicle_shapes(
    agent: SceneActor, pose: tuple[float, float, float], color: str
) -> Iterator[_Shape]:
    """A footprint, and a dark band where it looks to."""
    size = (agent.length, agent.width)
    yield _Shape(_box(size, pose), color)
    yield _Shape(_box((0.12 * size[0], 0.8 * size[1]), pose, 0.2 * size[0]), _WINDSHIELD)


def _box(size: Sequence[float], pose: tuple[float, float, float], forward: float = 0.0) -> Floats:
    """(4, 2) corners of a rectangle (length, width), moved `forward` in its own direction."""
    x, y, heading = pose
    ahead = np.array([np.cos(heading), np.sin(heading)])
    left = np.array([-ahead[1], ahead[0]])
    along, across = 0.5 * size[0], 0.5 * size[1]
    corners = [(along, across), (-along, across), (-along, -across), (along, -across)]
    return np.array([(x, y) + (a + forward) * ahead + b * left for a, b in corners])


def _draw(pixels: Picture, shape: _Shape, place: Callable[[Floats], Floats]) -> None:
    import cv2

    corners = np.round(place(shape.points) * 2**_FRACTION_BITS).astype(np.int32)
    color = _rgb(shape.color)
    if shape.width:
        thick = max(1, round(shape.width))
        cv2.polylines(pixels, [corners], False, color, thick, cv2.LINE_AA, _FRACTION_BITS)
    else:
        cv2.fillPoly(pixels, [corners], color, cv2.LINE_AA, _FRACTION_BITS)


def _rgb(color: str) -> tuple[int, int, int]:
    return int(color[1:3], 16), int(color[3:5], 16), int(color[5:7], 16)
