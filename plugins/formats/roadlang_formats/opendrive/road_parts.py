"""The roads of a scene as OpenDRIVE has them: cut at junctions, and loops in parts."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Literal, TypeAlias

import numpy as np

from roadlang.geometry import CrossSection, Curve, Floats

from ..surfaces.built import built_roads, is_loop
from .carriageways import (
    Carriageway,
    left_hand_carriageways,
    one_way,
    reversed_road,
    shared_lane,
)
from .direct_links import End, Links, direct_links
from .lane_numbers import LaneNumbers, lane_numbers
from .plan_view import ReferenceLine, reference_line
from .road_ids import own_ids
from .sampled_line import SampledLine, poses_between, whole_turns

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneRoad

LeftHand: TypeAlias = Literal["one_way_roads", "rule"]
"""How left-hand traffic is written."""
_LOOP_PARTS = 3
"""netconvert does not take a road that follows itself, or its own successor."""
_RETURNING_PARTS = 2
"""Of a road whose ends are at one junction: CARLA does not tell its ends apart there."""
_ENDS: tuple[End, End] = ("start", "end")
_SAME = 1e-6
"""Meters between stations that are one."""
_SHORTEST = 0.2
"""Meters of a piece of a reference line at the end of a part, at least: netconvert takes cubics of
less than 0.1 m twice."""
_MOVED = 0.3
"""Share of the length of a part by which a cut between two may be moved to where it is straight."""
_AROUND = 4.0
"""Meters to each side of a cut in which bends count: where they do, netconvert makes a node that
shortens both parts."""
_BENT, _STRAIGHTER = 0.002, 0.5
"""1/m: less bend is no reason to move a cut, and neither is a place with more than that share."""


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
    lane_ids: Mapping[int, int]
    """ids of OpenDRIVE by those of the lanes of the road in the scene; `road` may have others"""
    rule: Literal["RHT", "LHT"]
    links: Mapping[End, PartLink] = field(default_factory=dict)
    reverse_of: int | None = None
    """the part with the other direction of the same road of the scene; `road` runs against that"""
    shares_lane: bool = False
    """whether its lane is that of the part that it is the reverse of"""

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


def road_parts(scene: Scene, tolerance: float, left_hand: LeftHand) -> tuple[OpenDriveRoad, ...]:
    """All roads that are built; none that junctions have swallowed. `town/5` has the id 5."""
    on_left = scene.world.get("traffic") == "left"
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
        start, end = (
            0.0 if (road.name, at) in links else trim
            for at, trim in zip(_ENDS, road.trim, strict=True)
        )
        cut = _Cut(_cuts(road, count, start, end), is_loop(road), tolerance)
        ways = _ways(road, on_left, left_hand)
        found = cut.parts(ways.along, len(parts) + 1, ways.on_left)
        if ways.against is not None:
            back = replace(cut, cuts=road.length - cut.cuts[::-1])
            turned = back.parts(ways.against, len(parts) + len(found) + 1, ways.on_left)
            found += [
                replace(part, reverse_of=other.id, shares_lane=ways.share_lane)
                for part, other in zip(turned, found[::-1], strict=True)
            ]
        parts += found
    ends = PartEnds.of(parts)
    ids = own_ids({part.id: part.road for part in parts})
    return tuple(_renumbered(_linked(part, links, ends), ids) for part in parts)


def _renumbered(part: OpenDriveRoad, ids: Mapping[int, int]) -> OpenDriveRoad:
    linked = {end: link for end, link in part.links.items() if link.id in ids}
    return replace(
        part,
        id=ids[part.id],
        links={end: replace(link, id=ids[link.id]) for end, link in linked.items()},
        reverse_of=None if part.reverse_of is None else ids[part.reverse_of],
    )


@dataclass(frozen=True)
class _Ways:
    """A road as one road or two; whether two have the same lane, and whether `on_left` is the rule
    of their lanes."""

    along: Carriageway
    against: Carriageway | None
    share_lane: bool
    on_left: bool


def _ways(road: SceneRoad, on_left: bool, left_hand: LeftHand) -> _Ways:
    section = road.cross_section()
    if on_left and lane_numbers(section, left_hand=True).contrary:
        # Some roads have their lanes as in right-hand traffic, whatever the world says.
        on_left = bool(lane_numbers(section, left_hand=False).contrary)
    whole = Carriageway(road, {id: id for id in section.ids})
    shared = shared_lane(section)
    if shared is not None:
        return _Ways(whole, reversed_road(road, shared), True, on_left and left_hand == "rule")
    parted = left_hand_carriageways(road) if on_left and left_hand == "one_way_roads" else ()
    if not parted:
        return _Ways(whole, None, False, on_left)
    return _Ways(parted[0], parted[1] if len(parted) > 1 else None, False, False)


def _linked(part: OpenDriveRoad, links: Links, ends: PartEnds) -> OpenDriveRoad:
    """A part with the roads that follow the road of the scene at its ends."""
    found = dict(part.links)
    opposite: Mapping[End, End] = {"start": "end", "end": "start"}
    for end in _ENDS:
        at = end if part.reverse_of is None else opposite[end]
        link = links.get((part.road.name, at))
        if end in found or link is None:
            continue
        follow = ends.entering if end == "end" else ends.leaving
        other, other_end = follow(link.road, link.end)
        ids, others = part.lane_ids, other.lane_ids
        lanes = {
            ids[lane]: others[after]
            for lane, after in link.lanes.items()
            if lane in ids and after in others
        }
        if lanes:
            found[end] = PartLink(other.id, other_end, lanes)
    return replace(part, links=found) if found != part.links else part


@dataclass(frozen=True)
class _Cut:
    """The stations between which a road is cut into parts, and whether it follows itself."""

    cuts: Floats
    is_loop: bool
    tolerance: float

    def parts(self, way: Carriageway, first: int, on_left: bool) -> list[OpenDriveRoad]:
        """Of one direction where the road has a single lane for both."""
        road, count = way.road, len(self.cuts) - 1
        points = np.column_stack((road.x, road.y))
        curve = Curve.hermite(points, road.heading, closed=road.closed)
        stations = whole_turns(road)[:, 0]
        section = road.cross_section()
        shared = shared_lane(section)
        if shared is not None:
            section = one_way(section, shared)
        numbers = lane_numbers(section, on_left)
        ids = {lane: numbers.ids[other] for lane, other in way.lanes.items()}
        same = {id: id for id in numbers.ids.values()}
        spans = [_between(stations, low, high) for low, high in pairwise(self.cuts)]
        found: list[OpenDriveRoad] = []
        for place, at in enumerate(spans):
            if at is None:
                continue
            links: dict[End, PartLink] = {}
            if place or self.is_loop:
                links["start"] = PartLink(first + (place - 1) % count, "end", same)
            if place < count - 1 or self.is_loop:
                links["end"] = PartLink(first + (place + 1) % count, "start", same)
            line = reference_line(SampledLine.of(road, _apart(at)), self.tolerance)
            rule: Literal["RHT", "LHT"] = "LHT" if on_left else "RHT"
            found.append(
                OpenDriveRoad(
                    first + place, road, at, curve, line, section, numbers, ids, rule, links
                )
            )
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

    def leaving(self, road: str, end: End) -> tuple[OpenDriveRoad, End]:
        """The part by which traffic leaves a road at this end, and which end of the part it is."""
        if end == "start" and (road, "end", True) in self._ends:
            return self._ends[road, "end", True], "end"
        return self._ends[road, end, False], end

    def entering(self, road: str, end: End) -> tuple[OpenDriveRoad, End]:
        """The part by which traffic enters a road at this end, and which end of the part it is."""
        if end == "end" and (road, "start", True) in self._ends:
            return self._ends[road, "start", True], "start"
        return self._ends[road, end, False], end


def _cuts(road: SceneRoad, count: int, start: float, end: float) -> Floats:
    """(count + 1,) stations between which a road is cut, `start` and `end` meters from its ends:
    into equal parts, except that no cut is in a bend if there is a straighter place near by."""
    cuts = np.linspace(start, road.length - end, count + 1)
    stations, bends = np.array(road.stations), np.abs(road.curvature)
    part = float(cuts[1] - cuts[0])
    places = np.linspace(-_MOVED * part, _MOVED * part, 2 * math.ceil(_MOVED * part) + 1)
    places = places[np.argsort(np.abs(places), kind="stable")]
    around = np.linspace(-_AROUND, _AROUND, 17)
    for number in range(1, count):
        near = cuts[number] + places
        sharpest = np.interp(near[:, None] + around, stations, bends).max(axis=1)
        best = int(sharpest.argmin())
        if sharpest[0] > _BENT and sharpest[best] < _STRAIGHTER * sharpest[0]:
            cuts[number] = near[best]
    return np.asarray(cuts)


def _apart(stations: Floats) -> Floats:
    """The stations without those next to the first and last that are too near to them."""
    far = (stations > stations[0] + _SHORTEST) & (stations < stations[-1] - _SHORTEST)
    far[[0, -1]] = True
    return np.asarray(stations[far])


def _between(stations: Floats, start: float, stop: float) -> Floats | None:
    """The stations from `start` to `stop`, both among them; None where nothing lies between."""
    if stop - start <= _SAME:
        return None
    inner = stations[(stations > start + _SAME) & (stations < stop - _SAME)]
    return np.concatenate(([start], inner, [stop]))
