"""The speed limits of the lanes of a road, by arc length."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from ...geometry import Lane
from ...geometry.arrays import Floats, Integers
from ...ir.scene import SceneRoad


@dataclass(frozen=True)
class SpeedZones:
    """`limits` (Z, L), m/s, infinite for none, from the arc lengths `starts` (Z,) on."""

    starts: Floats
    limits: Floats

    @classmethod
    def of(cls, road: SceneRoad, lanes: Sequence[Lane]) -> SpeedZones:
        """Those of a road with these lanes."""
        zones = road.zones()
        limits = [
            [_limit(zone.speed_limit if lane.speed_limit is None else lane.speed_limit)
             for lane in lanes]
            for zone in zones
        ]  # fmt: skip
        return cls(np.array([zone.start for zone in zones]), np.array(limits))

    def zone(self, station: Floats) -> Integers:
        """The number of the zone at each arc length, in its shape."""
        return np.maximum(np.searchsorted(self.starts, station, side="right") - 1, 0)


def any_limit(roads: Iterable[SceneRoad]) -> bool:
    """Whether any lane of any road has a speed limit. Roads that are bent in many ways share their
    lanes, which are looked at once."""
    alike = {(road.speed_limit, id(road.speed_zones), id(road.lane_list)): road for road in roads}
    return any(map(has_limit, alike.values()))


def has_limit(road: SceneRoad) -> bool:
    """Whether any lane of a road has a speed limit anywhere."""
    of_road = any(zone.speed_limit is not None for zone in road.zones())
    return of_road or any(lane.speed_limit is not None for lane in road.lane_list)


def _limit(limit: float | None) -> float:
    return math.inf if limit is None else float(limit)
