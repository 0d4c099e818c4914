"""The roads of a scene as OpenDRIVE has them: cut at junctions, and loops in parts."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry import CrossSection, Curve, Floats

from ..surfaces.built import built_roads, is_loop
from .both_ways import one_way, reversed_road, shared_lane
from .direct_links import End, Links, direct_links
from .lane_numbers import LaneNumbers, lane_numbers
from .plan_view import (
    ReferenceLine,
    SampledLine,
    poses_between,
    reference_line,
    whole_turns,
)

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneRoad

_LOOP_PARTS = 3
"""netconvert does not take a road that follows itself, or its own successor."""
_RETURNING_PARTS = 2
"""Of a road whose ends are at one junction: CARLA does not tell its ends apart there."""
_SAME = 1e-6
"""Meters between stations that are one."""


@dataclass(frozen=True)
class PartLink:
    """The end of the road before or after a part, and its lanes by those of the part: ids of
    OpenDRIVE."""

    id: int
    end: End
    lanes: Mapping[int, int]


@dataclass(frozen=True)
class OpenDriveRoad:
    """A road of OpenDRIVE: a part of a road of the scene, at these of its stations (n,). `links`:
    what follows at its ends without a junction."""

    id: int
    road: SceneRoad
    stations: Floats
    curve: Curve
    line: ReferenceLine
    section: CrossSection
    numbers: LaneNumbers
    links: Mapping[End, PartLink] = field(default_factory=dict)
    reverse_of: int | None = None
    """the part on the same ground whose lane this one has for the other direction; its `road` runs
    that direction"""

    @property
    def arc_lengths(self) -> Floats:
        """(n,) of the stations, along the reference line."""
        return self.line.at(self.stations)

    def nearest(self, points: Floats) -> Floats:
        """(n,) stations of this part that are nearest to points (n, 2)."""
        scale = self.road.length / self.curve.length
        return np.clip(self.curve.project(points)[0] * scale, self.stations[0], self.stations[-1])

    def pose(self, stations: Floats) -> Floats:
        """(n, 3) x, y and heading at stations (n,)."""
        return poses_between(whole_turns(self.road), stations)


def road_parts(scene: Scene, tolerance: float) -> tuple[OpenDriveRoad, ...]:
    """All roads that are built, from the first number on; none that junctions have swallowed."""
    left_hand = scene.world.get("traffic") == "left"
    junctions = [junction for network in scene.networks for junction in network.junctions]
    returning = {
        name
        for junction in junctions
        for name, ends in Counter(arm.road for arm in junction.arms).items()
        if ends > 1
    }
    parts: list[OpenDriveRoad] = []
    links = direct_links(scene)
    for road in built_roads(scene):
        count = _RETURNING_PARTS if road.name in returning else 1
        if is_loop(road):
            count = _LOOP_PARTS
        first = len(parts) + 1
        start, end = road.trim
        trims = (
            0.0 if (road.name, "start") in links else start,
            0.0 if (road.name, "end") in links else end,
        )
        found = _parts(road, trims, count, first, left_hand, tolerance)
        lane = shared_lane(road.cross_section())
        if lane is not None:
            back = reversed_road(road, lane)
            turned = _parts(back, back.trim, count, first + len(found), left_hand, tolerance)
            ids = [part.id for part in reversed(found)]
            found += [replace(part, reverse_of=id) for part, id in zip(turned, ids, strict=True)]
        parts += found
    return tuple(_linked(part, links, PartEnds.of(parts)) for part in parts)


def _linked(part: OpenDriveRoad, links: Links, ends: PartEnds) -> OpenDriveRoad:
    """A part with the roads that follow the road of the scene at its ends."""
    found = dict(part.links)
    both: tuple[End, ...] = ("start", "end")
    for end in both:
        link = links.get((part.road.name, end))
        if end in found or link is None:
            continue
        other, _ = ends.entering(link.road, link.end)
        ids, others = part.numbers.ids, other.numbers.ids
        lanes = {ids[lane]: others[after] for lane, after in link.lanes.items()}
        found[end] = PartLink(other.id, link.end, lanes)
    return replace(part, links=found) if found != part.links else part


def _parts(
    road: SceneRoad,
    trims: tuple[float, float],
    count: int,
    first: int,
    left_hand: bool,
    tolerance: float,
) -> list[OpenDriveRoad]:
    """Of one direction where the road has a single lane for both."""
    points = np.column_stack((road.x, road.y))
    curve = Curve.hermite(points, road.heading, closed=road.closed)
    stations = whole_turns(road)[:, 0]
    section = road.cross_section()
    shared = shared_lane(section)
    if shared is not None:
        section = one_way(section, shared)
    numbers = lane_numbers(section, left_hand)
    cuts = np.linspace(trims[0], road.length - trims[1], count + 1)
    same = {id: id for id in numbers.ids.values()}
    spans = [_between(stations, start, stop) for start, stop in pairwise(cuts)]
    found: list[OpenDriveRoad] = []
    for place, at in enumerate(spans):
        if at is None:
            continue
        id = first + place
        links: dict[End, PartLink] = {}
        if place or count == _LOOP_PARTS:
            links["start"] = PartLink(first + (place - 1) % count, "end", same)
        if place < count - 1 or count == _LOOP_PARTS:
            links["end"] = PartLink(first + (place + 1) % count, "start", same)
        fitted = reference_line(SampledLine.of(road, at), tolerance)
        found.append(OpenDriveRoad(id, road, at, curve, fitted, section, numbers, links))
    return found


@dataclass(frozen=True)
class PartEnds:
    """The parts at the ends of the roads of a scene."""

    _ends: Mapping[tuple[str, str, bool], OpenDriveRoad]

    @classmethod
    def of(cls, parts: Sequence[OpenDriveRoad]) -> PartEnds:
        """Of all parts of a scene, in order."""
        found: dict[tuple[str, str, bool], OpenDriveRoad] = {}
        for part in parts:
            is_reverse = part.reverse_of is not None
            found.setdefault((part.road.name, "start", is_reverse), part)
            found[part.road.name, "end", is_reverse] = part
        return cls(found)

    def has(self, road: str) -> bool:
        """Whether a road is written."""
        return (road, "start", False) in self._ends

    def leaving(self, road: str, end: str) -> tuple[OpenDriveRoad, str]:
        """The part by which traffic leaves a road at this end, and which end of the part it is."""
        if end == "start" and (road, "end", True) in self._ends:
            return self._ends[road, "end", True], "end"
        return self._ends[road, end, False], end

    def entering(self, road: str, end: str) -> tuple[OpenDriveRoad, str]:
        """The part by which traffic enters a road at this end, and which end of the part it is."""
        if end == "end" and (road, "start", True) in self._ends:
            return self._ends[road, "start", True], "start"
        return self._ends[road, end, False], end


def _between(stations: Floats, start: float, stop: float) -> Floats | None:
    """The stations from `start` to `stop`, both among them; None where nothing lies between."""
    if stop - start <= _SAME:
        return None
    inner = stations[(stations > start + _SAME) & (stations < stop - _SAME)]
    return np.concatenate(([start], inner, [stop]))
