"""Roads that are written as two, one for each direction.

No simulator drives a single lane for both directions both ways: it becomes two roads on the same
ground. CARLA, netconvert and Scenic have no left-hand traffic: there the lanes of each direction
become a road of their own that runs their way, so that they lie right of its reference line.
`userData` says which roads belong together, and `read with opendrive` makes one of them again.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal, TypeAlias

import numpy as np

from roadlang.api import SceneLane, SceneRoad, SurfacePatch
from roadlang.geometry import CrossSection, Floats, Lane

from .lane_numbers import lane_numbers

Direction: TypeAlias = Literal["forward", "backward", "both", "none"]
_BACK: Mapping[Direction, Direction] = {"forward": "backward", "backward": "forward"}


@dataclass(frozen=True)
class Carriageway:
    """Lanes of a road as a road of its own. `lanes`: its ids of lanes by those of the road."""

    road: SceneRoad
    lanes: Mapping[int, int]


def shared_lane(section: CrossSection) -> int | None:
    """The id of the lane that both directions share, if it is the only one for vehicles."""
    drivable = [lane for lane in section.lanes if lane.drivable]
    if len(drivable) == 1 and drivable[0].direction == "both":
        return drivable[0].id
    return None


def one_way(section: CrossSection, id: int) -> CrossSection:
    """The same lanes, that one for the direction of the road alone."""
    lanes = (
        replace(lane, direction="forward") if lane.id == id else lane for lane in section.lanes
    )
    return replace(section, lanes=tuple(lanes))


def reversed_road(road: SceneRoad, id: int) -> Carriageway:
    """The same road in the other direction, with this lane of it alone."""
    section = one_way(road.cross_section(), id)
    (place,) = (place for place, lane in enumerate(section.lanes) if lane.id == id)
    found = _carriageway(road, section, slice(place, place + 1), backward=True)
    (lane,) = found.road.lane_list
    return replace(found, road=replace(found.road, lane_list=(replace(lane, direction="forward"),)))


def left_hand_carriageways(road: SceneRoad) -> tuple[Carriageway, ...]:
    """Of a road in left-hand traffic: one along it, and one against it unless all its lanes run
    one way. None where lanes run against the traffic beside them, or where one is shared."""
    section = road.cross_section()
    numbers = lane_numbers(section, left_hand=True)
    if numbers.contrary or shared_lane(section) is not None:
        return ()
    sides = slice(0, numbers.left), slice(numbers.left, len(section.lanes))
    driven = [any(lane.drivable for lane in section.lanes[side]) for side in sides]
    if not all(driven):
        return (_carriageway(road, section, slice(None), backward=False),)
    return tuple(
        _carriageway(road, section, side, backward=backward)
        for side, backward in zip(sides, (False, True), strict=True)
    )


def _carriageway(
    road: SceneRoad, section: CrossSection, places: slice, *, backward: bool
) -> Carriageway:
    """The lanes at these places. Those for vehicles, and what lies beyond, are on the right."""
    stations = np.array(road.stations)
    lanes, borders = section.lanes[places], section.border_offsets(stations)
    start, stop, _ = places.indices(len(section.lanes))
    borders, marks = borders[start : stop + 1], section.markings[start : stop + 1]
    if backward:
        lanes, borders, marks = lanes[::-1], -borders[::-1], marks[::-1]
    left = next((place for place, lane in enumerate(lanes) if lane.drivable), 0)
    ids = {lane.id: left - k if k < left else left - k - 1 for k, lane in enumerate(lanes)}
    written = [
        SceneLane(
            ids[lane.id],
            lane.kind,
            _direction(lane, backward),
            _turned(road, section.lane_width(lane.id, stations), backward),
            lane.drivable,
            lane.speed_limit,
            marks[k if k < left else k + 1],
            lane.users,
            lane.raised,
        )
        for k, lane in enumerate(lanes)
    ]
    along = _against(road) if backward else road
    found = replace(
        along,
        lane_list=tuple(written),
        center_marking=marks[left],
        center_offset=_turned(road, borders[left], backward),
        surface_patches=tuple(_patches(along, ids)),
    )
    return Carriageway(found, ids)


def _direction(lane: Lane, backward: bool) -> Direction:
    return _BACK.get(lane.direction, lane.direction) if backward else lane.direction


def _turned(
    road: SceneRoad, values: Sequence[float] | Floats, backward: bool = True, first: float = 0.0
) -> tuple[float, ...]:
    """Values at the stations of a road, or in the other order; then `first` is added to that at
    the start of a loop."""
    found = np.array(values)
    if backward:
        found = found[::-1]
        if road.closed and len(found):
            found = np.append(found[-1] + first, found[:-1])
    return tuple(found.tolist())


def _against(road: SceneRoad) -> SceneRoad:
    """The same road in the other direction, but for its lanes."""
    around = 2.0 * np.pi * np.round((road.heading[-1] - road.heading[0]) / (2.0 * np.pi))
    return replace(
        road,
        stations=tuple(road.length - s for s in _turned(road, road.stations, first=road.length)),
        x=_turned(road, road.x),
        y=_turned(road, road.y),
        heading=tuple(at + math.pi for at in _turned(road, road.heading, first=around)),
        curvature=tuple(-curvature for curvature in _turned(road, road.curvature)),
        trim=(road.trim[1], road.trim[0]),
        speed_zones=tuple(
            replace(zone, start=road.length - end)
            for zone, end in zip(road.speed_zones[::-1], _zone_ends(road)[::-1], strict=True)
        ),
        elevation=_turned(road, road.elevation),
        surface_patches=tuple(
            replace(patch, start=road.length - patch.end, end=road.length - patch.start)
            for patch in road.surface_patches
        ),
    )


def _patches(road: SceneRoad, ids: Mapping[int, int]) -> list[SurfacePatch]:
    """Its patches with the ids of the lanes that are left of it."""
    found = []
    for patch in road.surface_patches:
        lanes = tuple(ids[lane] for lane in patch.lanes or ids if lane in ids)
        if lanes:
            found.append(replace(patch, lanes=() if len(lanes) == len(ids) else lanes))
    return found


def _zone_ends(road: SceneRoad) -> list[float]:
    """Where the speed zones of a road end."""
    zones = road.speed_zones
    return [*(zone.start for zone in zones[1:]), road.length] if zones else []
