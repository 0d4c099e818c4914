"""The roads of a scene as OpenDRIVE has them: cut at junctions, and loops in three parts."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry import CrossSection, Curve, Floats

from ..surfaces.built import built_roads
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

_PARTS = 3
"""Of a loop: netconvert does not take a road that follows itself, or its own successor."""
_SAME = 1e-6
"""Meters between stations that are one."""


@dataclass(frozen=True)
class OpenDriveRoad:
    """A road of OpenDRIVE: a part of a road of the scene, at these of its stations (n,)."""

    id: int
    road: SceneRoad
    stations: Floats
    curve: Curve
    line: ReferenceLine
    section: CrossSection
    numbers: LaneNumbers
    previous: int | None = None
    next: int | None = None
    """ids of the parts of the same loop before and after it"""

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
    parts: list[OpenDriveRoad] = []
    for road in built_roads(scene):
        parts += _parts(road, len(parts) + 1, left_hand, tolerance)
    return tuple(parts)


def _parts(road: SceneRoad, first: int, left_hand: bool, tolerance: float) -> list[OpenDriveRoad]:
    points = np.column_stack((road.x, road.y))
    curve = Curve.hermite(points, road.heading, closed=road.closed)
    stations = whole_turns(road)[:, 0]
    section = road.cross_section()
    numbers = lane_numbers(section, left_hand)
    before, after = road.trim
    is_loop = road.closed and before == after == 0.0
    cuts = np.linspace(before, road.length - after, (_PARTS if is_loop else 1) + 1)
    found: list[OpenDriveRoad] = []
    for place, (start, stop) in enumerate(pairwise(cuts)):
        at = _between(stations, start, stop)
        if at is None:
            continue
        previous = following = None
        if is_loop:
            previous, following = (first + (place + step) % _PARTS for step in (-1, 1))
        id = first + len(found)
        fitted = reference_line(SampledLine.of(road, at), tolerance)
        part = OpenDriveRoad(id, road, at, curve, fitted, section, numbers, previous, following)
        found.append(part)
    return found


def _between(stations: Floats, start: float, stop: float) -> Floats | None:
    """The stations from `start` to `stop`, both among them; None where nothing lies between."""
    if stop - start <= _SAME:
        return None
    inner = stations[(stations > start + _SAME) & (stations < stop - _SAME)]
    return np.concatenate(([start], inner, [stop]))
