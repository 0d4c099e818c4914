"""The roads through junctions, one with one lane for each connection of the scene."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

import numpy as np

from roadlang.geometry import poses_along

from .elements import put
from .lanes import put_material
from .pieces import FLATTEST_ARC, ReferencePiece, cubic
from .reference import put_elevation, put_plan_view

if TYPE_CHECKING:
    from roadlang.api import SceneConnection

    from .road_parts import OpenDriveRoad

_SHORTEST = 1e-6
"""Meters of a piece."""
_STRAIGHT = 1e-9
"""1/m"""


@dataclass(frozen=True)
class RoadEnd:
    """Where a lane of the scene begins or ends in OpenDRIVE."""

    part: OpenDriveRoad
    end: str
    lane: int

    @property
    def height(self) -> float:
        """Of the road there, meters."""
        heights = self.part.road.elevation
        if not heights:
            return 0.0
        at = self.part.stations[0 if self.end == "start" else -1]
        return float(np.interp(at, self.part.road.stations, heights))


@dataclass(frozen=True)
class ConnectingRoad:
    """A road within a junction. `junction` is its number there."""

    id: int
    junction: int
    connection: SceneConnection
    source: RoadEnd
    target: RoadEnd
    lane: int
    """the id of its lane, which runs along the road: 1 in left-hand traffic, else -1"""


def pieces_of(connection: SceneConnection) -> tuple[ReferencePiece, ...]:
    """Its lines and arcs. An arc that does not turn is a line, because readers divide by
    curvatures; one that hardly turns is a cubic."""
    found: list[ReferencePiece] = []
    s, pose = 0.0, np.array(connection.start)
    for length, curvature in _merged(connection):
        x, y, heading = pose.tolist()
        after = poses_along(pose, (curvature, curvature), np.array([0.0, length]))[-1]
        if curvature == 0.0:
            found.append(ReferencePiece(s, x, y, heading, length, "line"))
        elif abs(curvature) < FLATTEST_ARC:
            numbers = cubic(pose, after, length)
            found.append(ReferencePiece(s, x, y, heading, length, "paramPoly3", numbers))
        else:
            found.append(ReferencePiece(s, x, y, heading, length, "arc", (curvature,)))
        pose = after
        s += length
    return tuple(found)


def _merged(connection: SceneConnection) -> list[tuple[float, float]]:
    """Lengths and curvatures of pieces, those that go on in the same way as one."""
    found: list[tuple[float, float]] = []
    for length, exact in connection.pieces:
        curvature = 0.0 if abs(exact) < _STRAIGHT else exact
        if length < _SHORTEST:
            continue
        if found and found[-1][1] == curvature:
            length += found.pop()[0]
        found.append((length, curvature))
    return found


def put_connecting_road(root: Element, road: ConnectingRoad, rule: str, speed: float) -> None:
    """A `road` element. `speed`: the limit where it leads, m/s, infinite for none."""
    pieces = pieces_of(road.connection)
    length = pieces[-1].s + pieces[-1].length
    name = f"{road.connection.turn} turn" if road.connection.turn != "straight" else "straight on"
    found = put(root, "road", name=name, length=length, id=road.id, junction=road.junction)
    found.set("rule", rule)
    link = put(found, "link")
    for tag, at in (("predecessor", road.source), ("successor", road.target)):
        put(link, tag, elementType="road", elementId=at.part.id, contactPoint=at.end)
    kind = put(found, "type", s=0.0, type="town")
    if np.isfinite(speed):
        put(kind, "speed", max=speed, unit="m/s")
    put_plan_view(found, pieces)
    low, high = road.source.height, road.target.height
    put_elevation(found, [(0.0, low, (high - low) / length)])
    _put_lane(put(found, "lanes"), road, length, left_hand=rule == "LHT")


def _put_lane(lanes: Element, road: ConnectingRoad, length: float, left_hand: bool) -> None:
    before, after = road.connection.widths
    slope = (after - before) / length
    # The reference line is the middle of the lane, so that the two are equally exact.
    side = -0.5 if left_hand else 0.5
    put(lanes, "laneOffset", s=0.0, a=side * before, b=side * slope, c=0.0, d=0.0)
    section = put(lanes, "laneSection", s=0.0)
    if left_hand:
        lane = put(put(section, "left"), "lane", id=1, type="driving", level="false")
    center = put(put(section, "center"), "lane", id=0, type="none", level="false")
    _put_no_mark(center)
    if not left_hand:
        lane = put(put(section, "right"), "lane", id=-1, type="driving", level="false")
    link = put(lane, "link")
    put(link, "predecessor", id=road.source.lane)
    put(link, "successor", id=road.target.lane)
    put(lane, "width", sOffset=0.0, a=before, b=slope, c=0.0, d=0.0)
    _put_no_mark(lane)
    surface = road.source.part.road.surface
    if surface is not None:
        put_material(lane, 0.0, surface)


def _put_no_mark(lane: Element) -> None:
    mark = put(lane, "roadMark", sOffset=0.0, type="none", weight="standard")
    mark.set("color", "standard")
    mark.set("width", "0")
    mark.set("laneChange", "none")
