"""What is painted at the junctions of a scene, and its crosswalks: for every backend the same
shapes, in meters."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from ..geometry.arrays import Floats
from ..geometry.lanes.lane_paint import LINE_WIDTH
from ..ir.scene import Scene
from ..ir.scene_junctions import SceneConnection, SceneJunction
from ..ir.scene_road import SceneRoad
from .junction_curbs import edge_lines
from .lines_through import lines_through
from .turn_arrows import arrow
from .zebra_crossings import crossings, crosswalk_stripes

STOP_LINE = 0.4
"""Meters: the width of a stop line and of a line to yield at."""
ARROW_LINE = 0.15
_TEETH = (0.5, 0.4)
_ARROW_BEFORE = 9.0
_ARROW_ROOM = 14.0


@dataclass(frozen=True, eq=False)
class PaintedShape:
    """A shape in white: a line of some width, or the inside of a ring."""

    kind: Literal[
        "stop_line", "yield_line", "arrow", "crossing", "lane_line", "edge_line", "corner_line"
    ]
    """what it is for; `edge_line`: along the mouth of a minor road; `corner_line`: the edge line
    around a corner"""
    points: Floats
    """(n, 2) meters"""
    width: float = 0.0
    """of a line, meters; 0: a ring that is filled"""
    dashes: tuple[float, float] | None = None
    """meters painted and left out, in turn, along a broken line"""


def junction_paint(scene: Scene, junctions: Iterable[SceneJunction]) -> Iterator[PaintedShape]:
    """Stop lines, lines to yield at, turn arrows, zebra crossings between sidewalks, broken lines
    of priority roads (a shape for each dash) that go straight on, and the edge lines around
    corners."""
    roads = {road.name: road for road in scene.roads}
    for junction in junctions:
        if junction.kind == "joint":
            continue
        for stripe in crossings(junction, roads):
            yield PaintedShape("crossing", stripe)
        for line in lines_through(junction, roads):
            yield PaintedShape(line.kind, line.points, LINE_WIDTH)
        for points in edge_lines(junction, roads):
            yield PaintedShape("corner_line", points, LINE_WIDTH)
        lanes = connections_by_lane(junction)
        for connections in lanes.values():
            yield from _line(junction, connections[0])
        for (road, end, _), connections in lanes.items():
            beside = sum(key[:2] == (road, end) for key in lanes)
            if beside > 1 and roads[road].length - sum(roads[road].trim) > _ARROW_ROOM:
                yield from _arrow(roads[road], connections)


def crosswalk_paint(scene: Scene) -> Iterator[PaintedShape]:
    """The stripes of the crosswalks of a scene."""
    for marking in scene.markings:
        for stripe in crosswalk_stripes(marking):
            yield PaintedShape("crossing", stripe)


def connections_by_lane(
    junction: SceneJunction,
) -> dict[tuple[str, str, int], list[SceneConnection]]:
    """The connections out of each lane that enters the junction, by road, end and lane."""
    lanes: dict[tuple[str, str, int], list[SceneConnection]] = {}
    for connection in junction.connections:
        source = connection.source
        lanes.setdefault((source.road, source.end, source.lane), []).append(connection)
    return lanes


def _line(junction: SceneJunction, connection: SceneConnection) -> Iterator[PaintedShape]:
    """Solid where vehicles stop, broken where they yield."""
    control, road = junction.control, connection.source.road
    stops = control.kind in ("all_way_stop", "signals") or (
        control.kind == "stop" and road in control.minor
    )
    ids = {c.id for c in junction.connections if c.source == connection.source}
    enters = junction.kind == "roundabout" and any(a in ids for a, _ in junction.yields)
    points = np.array(connection.stop_line)
    if stops:
        yield PaintedShape("stop_line", points, STOP_LINE)
    elif enters or (control.kind == "yield" and road in control.minor):
        yield PaintedShape("yield_line", points, STOP_LINE, _TEETH)


def _arrow(road: SceneRoad, connections: Sequence[SceneConnection]) -> Iterator[PaintedShape]:
    """Where the lane of the connections leads, painted some meters before the stop line."""
    first = connections[0]
    at_end = first.source.end == "end"
    face = road.stations[-1] - road.trim[1] if at_end else road.trim[0]
    before = face - _ARROW_BEFORE if at_end else face + _ARROW_BEFORE
    place = np.mean(first.stop_line, axis=0)
    offset = (place - _point(road, face)) @ _left(road, face)
    x, y = _point(road, before) + offset * _left(road, before)
    heading = float(np.interp(before, road.stations, road.heading)) + (0.0 if at_end else np.pi)
    turns = {connection.turn for connection in connections}
    for points, is_head in arrow(turns, x, y, heading):
        yield PaintedShape("arrow", points, 0.0 if is_head else ARROW_LINE)


def _point(road: SceneRoad, station: float) -> Floats:
    return np.array([np.interp(station, road.stations, column) for column in (road.x, road.y)])


def _left(road: SceneRoad, station: float) -> Floats:
    heading = np.interp(station, road.stations, road.heading)
    return np.array([-np.sin(heading), np.cos(heading)])
