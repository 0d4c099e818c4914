"""Places as OpenSCENARIO has them: on a lane of the road network, else in the world."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import zip_longest
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

import numpy as np

from ..opendrive.elements import put

if TYPE_CHECKING:
    from roadlang.api import SceneActor

    from ..opendrive.road_parts import OpenDriveRoad

_BEYOND = 1e-3
"""Meters past the end of a road from which on a place is not on it."""
_EDGE = 1e-6
"""Meters from the ends of a road that a place on it keeps."""
_STEPS = 3
"""Until the nearest station no longer changes."""


@dataclass(frozen=True)
class PlaceOnLane:
    """A place on a lane of the OpenDRIVE file: ids, arc length, and offset to the left."""

    road: int
    lane: int
    s: float
    offset: float


@dataclass(frozen=True)
class Place:
    """x and y in meters, heading in radians; `lane` where it is on one, and whether its heading is
    part of it."""

    x: float
    y: float
    heading: float
    lane: PlaceOnLane | None = None

    def put(self, parent: Element, turned: bool = True) -> None:
        """A `Position`. Without `turned` the heading is left out."""
        position = put(parent, "Position")
        if self.lane is None:
            world = put(position, "WorldPosition", x=self.x, y=self.y)
            if turned:
                world.set("h", f"{math.remainder(self.heading, math.tau) + 0.0:.12g}")
            return
        at = self.lane
        found = put(
            position, "LanePosition", roadId=at.road, laneId=at.lane, s=at.s, offset=at.offset
        )
        if turned:
            heading = math.remainder(self.heading, math.tau)
            put(found, "Orientation", type="absolute", h=heading)


@dataclass(frozen=True)
class Roads:
    """The roads of the OpenDRIVE file."""

    parts: tuple[OpenDriveRoad, ...]

    def place(self, x: float, y: float, heading: float, road: str | None = None) -> Place:
        """Of a point. `road`: of the scene, on which it is looked for first. Of two roads on the
        same ground, that which runs in its direction."""
        pairs = {part.reverse_of: part for part in self.parts if part.reverse_of is not None}
        first = sorted(self.parts, key=lambda part: part.road.name != road)
        for part in first:
            found = _on_part(part, x, y)
            if found is None:
                continue
            at, back = part.line.pose(found.s)[2], pairs.get(part.id)
            if back is not None and math.cos(heading - at) < 0.0:
                found = _on_part(back, x, y) or found
            return Place(x, y, heading, found)
        return Place(x, y, heading)

    def at(self, road: str, lane: int, station: float, back: bool = False) -> Place | None:
        """The middle of a lane of a road of the scene; None where the file has no such place.

        `back`: of a lane for both directions, which the file has once for each, the other one.
        """
        of_road = [part for part in self.parts if part.road.name == road]
        turned = [part for part in of_road if part.reverse_of is not None]
        if back and turned:
            of_road, lane = turned, turned[0].road.lane_list[0].id
            station = turned[0].road.length - station
        else:
            of_road = [part for part in of_road if part.reverse_of is None]
        fitting = [part for part in of_road if lane in part.section.ids]
        if not fitting:
            return None
        part = min(fitting, key=lambda part: abs(_within(part, station) - station))
        at = _within(part, station)
        x, y, heading = part.pose(np.array([at]))[0].tolist()
        offset = float(part.section.offset(lane, at))
        x, y = x - offset * math.sin(heading), y + offset * math.cos(heading)
        id = part.numbers.ids[lane]
        return Place(x, y, heading, PlaceOnLane(part.id, id, _arc_length(part, at), 0.0))


def _within(part: OpenDriveRoad, station: float) -> float:
    """The station of a part that is nearest to one of its road."""
    return min(max(station, float(part.stations[0])), float(part.stations[-1]))


def _on_part(part: OpenDriveRoad, x: float, y: float) -> PlaceOnLane | None:
    point = np.array([[x, y]])
    at = float(part.nearest(point)[0])
    along = left = 0.0
    for _ in range(_STEPS):
        px, py, heading = part.pose(np.array([at]))[0].tolist()
        dx, dy = x - px, y - py
        along = dx * math.cos(heading) + dy * math.sin(heading)
        left = dy * math.cos(heading) - dx * math.sin(heading)
        inside = _within(part, at + along)
        along, at = at + along - inside, inside
    if abs(along) > _BEYOND:
        return None
    lane = int(part.section.lane_at(left, at))
    if lane == 0:
        return None
    offset = left - float(part.section.offset(lane, at))
    return PlaceOnLane(part.id, part.numbers.ids[lane], _arc_length(part, at), offset)


def _arc_length(part: OpenDriveRoad, station: float) -> float:
    s = float(part.line.at(np.array([station]))[0])
    return min(max(s, _EDGE), part.line.length - _EDGE)


def route_places(roads: Roads, actor: SceneActor) -> Sequence[Place]:
    """Waypoints of the route of an agent; none without one: its start, the middle of each road in
    the lane that it leaves by, and its end. Of places on several lanes of a road the last."""
    if actor.route is None:
        return ()
    steps = actor.route.steps
    stations = [(steps[0], steps[0].start)]
    stations += [(step, (step.start + step.stop) / 2.0) for step in steps if step.turn is not None]
    stations.append((steps[-1], steps[-1].stop))
    found = [
        roads.at(step.road, step.lane, station, back=step.stop < step.start)
        for step, station in stations
    ]
    places = [place for place in found if place is not None]
    different = [p for p, q in zip(places, [None, *places], strict=False) if p != q]
    # esmini finds no way from one lane of a road to another.
    kept = [
        place
        for place, after in zip_longest(different, different[1:])
        if not _changes_lane(place, after)
    ]
    return kept if len(kept) > 1 else ()


def _changes_lane(place: Place, after: Place | None) -> bool:
    """Whether the place after this one is on another lane of the same road."""
    if after is None or place.lane is None or after.lane is None:
        return False
    return place.lane.road == after.lane.road and place.lane.lane != after.lane.lane
