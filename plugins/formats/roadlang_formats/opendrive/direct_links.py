"""Roads that go on in one another without a junction between them."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, TypeAlias

import numpy as np

from ..surfaces.built import built_junctions, built_roads, is_loop
from .carriageways import shared_lane

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneJunction, SceneRoad

End: TypeAlias = Literal["start", "end"]
_APART = 1e-3
"""Meters, and radians, by which reference lines may miss one another where they are linked."""
_BESIDE = 0.02
"""Meters by which the borders of linked lanes may miss one another."""


@dataclass(frozen=True)
class DirectLink:
    """The end of a road that follows, and its lanes by the ids of those that lead there."""

    road: str
    end: End
    lanes: Mapping[int, int]


Links: TypeAlias = Mapping[tuple[str, End], DirectLink]


def direct_links(scene: Scene) -> Links:
    """By the ends of roads, what they are linked to.

    Two roads at a joint are linked if their reference lines and lanes meet there, and if traffic
    goes from each lane into the one that continues it and into no other.
    """
    roads = {road.name: road for road in built_roads(scene)}
    found: dict[tuple[str, End], DirectLink] = {}
    junctions = [junction for _, junction in built_junctions(scene)]
    met = Counter((arm.road, arm.end) for junction in junctions for arm in junction.arms)
    for junction in junctions:
        # An end at two joints, as where both ends of a loop meet one road, leads to a junction.
        alone = all(met[arm.road, arm.end] == 1 for arm in junction.arms)
        if junction.kind != "joint" or not alone or len({a.road for a in junction.arms}) != 2:
            continue
        (one, end), (other, other_end) = ((arm.road, arm.end) for arm in junction.arms)
        lanes = _continued(roads[one], end, roads[other], other_end)
        if lanes and _is_all(junction, one, lanes, roads):
            found[one, end] = DirectLink(other, other_end, lanes)
            back = {after: before for before, after in lanes.items()}
            found[other, other_end] = DirectLink(one, end, back)
    return found


def _continued(one: SceneRoad, end: End, other: SceneRoad, other_end: End) -> dict[int, int]:
    """Which lanes of a road go on as which of another; none where the roads do not meet."""
    if any(is_loop(road) or shared_lane(road.cross_section()) is not None for road in (one, other)):
        return {}
    (x, y, outward), (u, v, inward) = _outward(one, end), _outward(other, other_end)
    turned = abs(math.remainder(outward - inward - math.pi, math.tau))
    if math.hypot(u - x, v - y) > _APART or turned > _APART:
        return {}
    # Offsets are positive to the left of the one who leaves `one`.
    leaving, entered = _lanes(one, end, 1.0), _lanes(other, other_end, -1.0)
    return {
        id: next_id
        for id, borders in leaving.items()
        for next_id, others in entered.items()
        if all(abs(a - b) <= _BESIDE for a, b in zip(borders, others, strict=True))
        and borders[0] - borders[1] > _BESIDE
    }


def _outward(road: SceneRoad, end: End) -> tuple[float, float, float]:
    """Where the road ends, and the heading of the one who leaves it there."""
    at = 0 if end == "start" else -1
    turned = math.pi if end == "start" else 0.0
    return road.x[at], road.y[at], road.heading[at] + turned


def _lanes(road: SceneRoad, end: End, side: float) -> dict[int, tuple[float, float]]:
    """The offsets of the left and right borders of its lanes, seen by the one who leaves the road
    there, or with `side` -1 by the one who enters it."""
    section = road.cross_section()
    s = 0.0 if end == "start" else road.length
    borders = section.border_offsets(s) * (side if end == "end" else -side)
    pairs = zip(borders[:-1].tolist(), borders[1:].tolist(), strict=True)
    return {
        lane.id: (max(pair), min(pair)) for lane, pair in zip(section.lanes, pairs, strict=True)
    }


def _is_all(
    junction: SceneJunction, one: str, lanes: Mapping[int, int], roads: Mapping[str, SceneRoad]
) -> bool:
    """Whether the connections of a joint are those of its lanes that continue one another."""
    back = {after: before for before, after in lanes.items()}
    if len(back) != len(lanes):
        return False
    for turn in junction.connections:
        onward = lanes if turn.source.road == one else back
        if onward.get(turn.source.lane) != turn.target.lane:
            return False
    led = {(turn.source.road, turn.source.lane) for turn in junction.connections}
    led |= {(turn.target.road, turn.target.lane) for turn in junction.connections}
    drivable = {
        (arm.road, lane.id)
        for arm in junction.arms
        for lane in roads[arm.road].cross_section().lanes
        if lane.drivable and lane.id in (lanes if arm.road == one else back)
    }
    return bool(np.all([pair in led for pair in drivable]))
