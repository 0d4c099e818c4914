"""Roads as edges of SUMO: one for each direction, cut where lanes begin or end."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from roadlang.api import LanePlace
from roadlang.geometry import CrossSection, Floats, Lane

from ..surfaces.built import is_loop
from .lane_lines import lane_line, line_length, simplified
from .vehicle_classes import LaneUse, permissions

if TYPE_CHECKING:
    from roadlang.api import SceneRoad

GAP = 0.1
"""Meters between the edges of one road: the least length of a lane in SUMO."""
_SHORTEST = 5.0
"""Meters between two cuts of a road."""
_PARTS = 3
"""Of a loop, so that no edge follows itself."""
_PRESENT = 0.5
"""Share of its greatest width that a lane has where it can be used."""


@dataclass(frozen=True)
class SumoLane:
    """A lane by its id in the scene: width (m), limit (m/s), and points (n, 2) as it is driven."""

    id: int
    width: float
    speed: float
    line: Floats
    permissions: str


@dataclass(frozen=True)
class SumoEdge:
    """One direction of a part of a road: its lanes from the edge of the road inward.

    `start` and `stop` are stations, in the direction of the road.
    """

    id: str
    road: SceneRoad
    forward: bool
    start: float
    stop: float
    length: float
    lanes: tuple[SumoLane, ...]
    source: str
    target: str

    def index(self, lane: int) -> int | None:
        """The number in SUMO of a lane of the scene; None where it is not there."""
        return next((n for n, found in enumerate(self.lanes) if found.id == lane), None)


def road_edges(
    road: SceneRoad, ends: tuple[str, str], left_hand: bool, use: LaneUse
) -> list[SumoEdge]:
    """Of a road between two nodes: those along it in order, then those against it in order."""
    section = road.cross_section()
    cuts = _cuts(road, section, returns=ends[0] == ends[1])
    count = len(cuts) - 1
    between = [f"{road.name}.{number}" for number in range(1, count)]
    if is_loop(road):
        nodes = [f"{road.name}.0", *between, f"{road.name}.0"]
    else:
        nodes = [ends[0], *between, ends[1]]
    found: list[SumoEdge] = []
    for forward in (True, False):
        places = range(count) if forward else reversed(range(count))
        for number, place in enumerate(places):
            first, last = cuts[place], cuts[place + 1]
            if place > 0 or is_loop(road):
                first += GAP / 2.0
            if place < count - 1 or is_loop(road):
                last -= GAP / 2.0
            lanes = _lanes(road, section, (first, last), forward, use)
            if left_hand:
                lanes.reverse()
            if not lanes:
                continue
            sides = (nodes[place], nodes[place + 1])
            id = ("" if forward else "-") + road.name + (f"#{number}" if count > 1 else "")
            drivable = [lane for lane in lanes if section.lane(lane.id).drivable] or lanes
            length = float(np.mean([line_length(lane.line) for lane in drivable]))
            found.append(
                SumoEdge(
                    id,
                    road,
                    forward,
                    first,
                    last,
                    max(length, GAP),
                    _thinned(lanes),
                    sides[0 if forward else 1],
                    sides[1 if forward else 0],
                )
            )
    return found


def _thinned(lanes: Sequence[SumoLane]) -> tuple[SumoLane, ...]:
    return tuple(
        SumoLane(lane.id, lane.width, lane.speed, simplified(lane.line), lane.permissions)
        for lane in lanes
    )


def _cuts(road: SceneRoad, section: CrossSection, returns: bool) -> list[float]:
    """Stations where the road begins, is cut, and ends. `returns`: it ends where it begins, and
    netconvert takes no edge that does."""
    before, after = road.trim
    first, last = before, road.length - after
    if is_loop(road):
        return [first + (last - first) * part / _PARTS for part in range(_PARTS + 1)]
    wanted = [zone.start for zone in road.zones()[1:]]
    wanted += [(first + last) / 2.0] if returns else []
    stations = np.array(road.stations)
    for lane in section.lanes:
        widths = np.broadcast_to(lane.width.at(stations), stations.shape)
        there = widths >= _PRESENT * widths.max()
        changes = np.flatnonzero(there[1:] != there[:-1])
        wanted += ((stations[changes] + stations[changes + 1]) / 2.0).tolist()
    cuts = [first]
    for cut in sorted(wanted):
        if cut - cuts[-1] >= _SHORTEST and last - cut >= _SHORTEST:
            cuts.append(cut)
    return [*cuts, last]


def _lanes(
    road: SceneRoad,
    section: CrossSection,
    between: tuple[float, float],
    forward: bool,
    use: LaneUse,
) -> list[SumoLane]:
    """Those that are there between two stations, from right to left as they are driven."""
    start, stop = between
    stations = np.linspace(start, stop, 9)
    found = []
    for lane in _of_direction(section, forward):
        width = float(np.mean(lane.width.at(stations)))
        if width <= 0.0 or width < _PRESENT * np.max(lane.width.at(np.array(road.stations))):
            continue
        line = lane_line(road, section, lane.id, start, stop)
        line = line if forward else line[::-1]
        speed = _speed(road, lane, (start + stop) / 2.0)
        allowed = permissions(lane, use.get((road.name, lane.id), frozenset()))
        found.append(SumoLane(lane.id, width, speed, line, allowed))
    return found[::-1] if forward else found


def _of_direction(section: CrossSection, forward: bool) -> Iterator[Lane]:
    """The lanes that are used that way, from left to right; sidewalks where they lie."""
    ways = ("both", "forward" if forward else "backward")
    drivable = [place for place, lane in enumerate(section.lanes) if lane.drivable]
    middle = np.mean(drivable) if drivable else len(section.lanes) / 2.0
    one_way = {lane.direction for lane in section.lanes if lane.drivable} - {"both"}
    for place, lane in enumerate(section.lanes):
        if "pedestrian" in lane.users and not lane.drivable:
            if len(one_way) == 1:
                yields = forward == (one_way == {"forward"})
            else:
                yields = (place > middle) == forward
            if yields:
                yield lane
        elif lane.direction in ways and (lane.drivable or "bicycle" in lane.users):
            yield lane


def _speed(road: SceneRoad, lane: Lane, station: float) -> float:
    limit = road.limit_at(station, lane.speed_limit)
    return LanePlace.default_speed if limit is None else limit


def in_order(edges: Sequence[SumoEdge], forward: bool) -> list[SumoEdge]:
    """The edges of one direction of a road."""
    return [edge for edge in edges if edge.forward == forward]


def pairs_of_edges(edges: Sequence[SumoEdge], loop: bool) -> list[tuple[SumoEdge, SumoEdge]]:
    """Edges of one direction and what follows them on the same road."""
    pairs = list(pairwise(edges))
    return [*pairs, (edges[-1], edges[0])] if loop and edges else pairs
