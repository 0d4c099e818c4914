"""Roads with a single lane for both directions, which no simulator drives both ways.

They are written as two roads on the same ground, one for each direction. `userData` marks the
second, so that `read with opendrive` makes one road of them again.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from roadlang.api import SceneLane, SceneRoad, SurfacePatch
from roadlang.geometry import CrossSection, Floats


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


def reversed_road(road: SceneRoad, id: int) -> SceneRoad:
    """The same road in the other direction, with this lane of it alone."""
    section, stations = road.cross_section(), np.array(road.stations)
    lane = section.lane(id)
    _, right = section.borders(id, stations)
    around = 2.0 * np.pi * np.round((road.heading[-1] - road.heading[0]) / (2.0 * np.pi))

    def turned(values: Sequence[float] | Floats, first: float = 0.0) -> tuple[float, ...]:
        """Values in the other order; `first` is added to that at the start of a loop."""
        backward = np.array(values)[::-1]
        if road.closed and len(backward):
            backward = np.append(backward[-1] + first, backward[:-1])
        return tuple(backward.tolist())

    width = turned(section.lane_width(id, stations))
    return replace(
        road,
        stations=tuple(road.length - s for s in turned(stations, road.length)),
        x=turned(road.x),
        y=turned(road.y),
        heading=tuple(heading + math.pi for heading in turned(road.heading, around)),
        curvature=tuple(-curvature for curvature in turned(road.curvature)),
        trim=(road.trim[1], road.trim[0]),
        lane_list=(
            SceneLane(
                -1, lane.kind, "forward", width, True, lane.speed_limit, lane.marking, lane.users
            ),
        ),
        center_offset=turned(-right),
        speed_zones=tuple(
            replace(zone, start=road.length - end)
            for zone, end in zip(road.speed_zones[::-1], _zone_ends(road)[::-1], strict=True)
        ),
        elevation=turned(road.elevation),
        surface_patches=tuple(
            SurfacePatch(patch.surface, road.length - patch.end, road.length - patch.start)
            for patch in road.surface_patches
            if id in (patch.lanes or (id,))
        ),
    )


def _zone_ends(road: SceneRoad) -> list[float]:
    """Where the speed zones of a road end."""
    zones = road.speed_zones
    return [*(zone.start for zone in zones[1:]), road.length] if zones else []
