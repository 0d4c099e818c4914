"""Where agents are on the cross-section of a road: lane, speed limit, how far off the road."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...geometry import CrossSection
from ...geometry.arrays import Booleans, Floats
from ...geometry.lanes.cross_section import drivable_borders
from ...ir.scene import SceneRoad
from .speed_zones import SpeedZones

LANE_COLUMNS = ("road", "lane", "lane_offset", "speed_limit", "off_road")
"""Members of `AgentTrace` that follow from poses, once the roads are known."""


@dataclass(frozen=True)
class OnRoad:
    """Arrays (R, T) of agents at times, seen along the road: meters, radians, 1/m."""

    station: Floats
    offset: Floats
    """of the center of the footprint, left of the curve"""
    error: Floats
    """heading of the agent from that of the road"""
    curvature: Floats
    """of the road"""


@dataclass(frozen=True)
class LaneSection:
    """The cross-section of a road, with the speed limits of its lanes."""

    section: CrossSection
    zones: SpeedZones

    @classmethod
    def of(cls, road: SceneRoad) -> LaneSection:
        """Those of a road. Raises GeometryError for lanes that cannot be."""
        section = road.cross_section()
        return cls(section, SpeedZones.of(road, section.lanes))

    @cached_property
    def is_constant(self) -> bool:
        """Whether the borders are the same all along the road."""
        center = self.section.center_offset
        profiles = [lane.width.widths for lane in self.section.lanes]
        profiles += [] if center is None else [center.offsets]
        return all(bool((values == values[0]).all()) for values in profiles)

    def columns(
        self, on: OnRoad, backward: Booleans, length: Floats, width: Floats
    ) -> Mapping[str, Floats]:
        """(R, T) `lane`, `lane_offset`, `speed_limit`, `off_road`.

        An agent is in the lane of its center, from beside the road in the outermost. `backward`
        (R, 1) travel against the road, where left is right; `length`, `width` (R, 1) are theirs.
        """
        borders = self._borders(on.station)
        place = (borders[1:-1] >= on.offset).sum(axis=0)
        lane = np.array(self.section.ids, dtype=np.float64)[place]
        middles = (borders[1:] + borders[:-1]) / 2.0
        middles = np.broadcast_to(middles, (len(middles), *on.offset.shape))
        from_middle = on.offset - np.take_along_axis(middles, place[None], axis=0)[0]
        return {
            "lane": lane,
            "lane_offset": np.where(backward, -from_middle, from_middle),
            "speed_limit": self.zones.limits[self.zones.zone(on.station), place],
            "off_road": self.off_road(on, length, width),
        }

    def off_road(self, on: OnRoad, length: Floats, width: Floats) -> Floats:
        """(R, T) that of `columns` alone."""
        return np.asarray(self.outside(on, corner_offsets(on, length, width)).max(axis=0))

    def outside(self, on: OnRoad, offsets: Floats) -> Floats:
        """(C, R, T) how far points beside the curve are outside the drivable lanes, meters; below
        zero within. `offsets` (C, R, T): left of the curve."""
        borders = self._borders(on.station)
        first, last = self._outermost
        return np.asarray(np.maximum(offsets - borders[first], borders[last] - offsets))

    @cached_property
    def _outermost(self) -> tuple[int, int]:
        """Between which borders one may drive."""
        drivable = np.array([lane.drivable for lane in self.section.lanes])
        first, last = drivable_borders(drivable)
        return first, last

    def _borders(self, station: Floats) -> Floats:
        """(L + 1, R, T), or (L + 1, 1, 1) where they are the same all along."""
        if self.is_constant:
            return self._constant_borders
        return np.asarray(self.section.border_offsets(station))

    @cached_property
    def _constant_borders(self) -> Floats:
        return np.asarray(self.section.border_offsets(np.zeros((1, 1))))


def corner_offsets(on: OnRoad, length: Floats, width: Floats) -> Floats:
    """(4, R, T) how far left of the curve the corners of footprints are, exact on arcs.

    A point `along` and `across` from the foot point lies at the distance `across` from the tangent;
    from the arc it lies at `m - k along^2 / (r + sqrt(r^2 + k^2 along^2))`, `m` the offset from the
    tangent, `k` the curvature, `r = 1 - k m`.
    """
    cosine, sine = np.cos(on.error), np.sin(on.error)
    ahead, left = _HALF_AHEAD * length, _HALF_LEFT * width
    along = ahead * cosine - left * sine
    m = on.offset + ahead * sine + left * cosine
    k_along = on.curvature * along
    r = np.maximum(1.0 - on.curvature * m, 0.0)
    root = r + np.sqrt(r * r + k_along * k_along)
    return np.asarray(m - k_along * along / np.where(root > 0.0, root, 1.0))


_HALF_AHEAD = np.array([0.5, -0.5, -0.5, 0.5])[:, None, None]
_HALF_LEFT = np.array([0.5, 0.5, -0.5, -0.5])[:, None, None]
"""(4, 1, 1) of the four corners, of the length and of the width."""


def on_road(road: SceneRoad, station: Floats, x: Floats, y: Floats, heading: Floats) -> OnRoad:
    """Poses beside a road, whose stations are known to within a meter or so.

    One step of Newton's method moves the station to the foot point of the pose.
    """
    stations = np.array(road.stations)
    columns = [np.array(values) for values in (road.x, road.y, road.curvature)]
    columns.append(np.unwrap(np.array(road.heading)))
    if road.closed:
        stations = np.append(stations, road.length)
        turn = round((columns[3][-1] - columns[3][0]) / math.tau) * math.tau
        ends = [columns[0][0], columns[1][0], columns[2][0], columns[3][0] + turn]
        columns = [np.append(column, end) for column, end in zip(columns, ends, strict=True)]

    def at(s: Floats) -> list[Floats]:
        s = s % road.length if road.closed else s
        return [np.interp(s, stations, values) for values in columns]

    for _ in range(2):
        px, py, curvature, along = at(station)
        ahead = (x - px) * np.cos(along) + (y - py) * np.sin(along)
        offset = (y - py) * np.cos(along) - (x - px) * np.sin(along)
        station = station + ahead / np.maximum(1.0 - curvature * offset, 0.5)
        if not road.closed:
            station = np.clip(station, stations[0], stations[-1])
    px, py, curvature, along = at(station)
    offset = (y - py) * np.cos(along) - (x - px) * np.sin(along)
    return OnRoad(station, offset, heading - along, curvature)
