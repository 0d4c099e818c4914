"""A road as the borders of its lanes in space."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry import CrossSection, Curve, Floats, Integers, offset

from ..opendrive.sampled_line import whole_turns
from .built import built_roads, is_loop
from .thinning import thinned

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneRoad

_SAME = 1e-6
"""Meters between stations that are one."""
_SPACING = 0.5
"""Meters between stations before they are thinned."""
_MOST = 50
"""Stations that one chord may skip."""


@dataclass(frozen=True)
class RoadSurface:
    """A road between its junctions, at n stations, also where its speed limit changes. A loop ends
    where it begins.

    `borders` (L + 1, n, 3) are the borders of its L lanes from left to right, x east, y north and
    z up in meters; `left` (n, 2) is the unit vector to the left, `slope` (n,) the rise per meter.
    """

    road: SceneRoad
    section: CrossSection
    stations: Floats
    borders: Floats
    left: Floats
    slope: Floats


def road_surfaces(scene: Scene, tolerance: float) -> Iterator[RoadSurface]:
    """The roads that are built, whose borders are chords within `tolerance` meters."""
    for road in built_roads(scene):
        surface = _surface(road, tolerance)
        if surface is not None:
            yield surface


def road_heights(road: SceneRoad, stations: Floats) -> Floats:
    """Heights (n,) of a road at its stations (n,), meters; 0 where the scene has none."""
    if not road.elevation:
        return np.zeros(np.shape(stations))
    period = road.length if road.closed else None
    return np.interp(stations, road.stations, road.elevation, period=period)


def _surface(road: SceneRoad, tolerance: float) -> RoadSurface | None:
    own = whole_turns(road)[:, 0]
    start, stop = road.trim[0], road.length - road.trim[1]
    if stop - start <= _SAME:
        return None
    even = np.linspace(start, stop, int((stop - start) / _SPACING) + 2)
    limits = np.array([zone.start for zone in road.zones()[1:]])
    inner, limits = (
        row[(row > start + _SAME) & (row < stop - _SAME)]
        for row in (np.append(own, limits), limits)
    )
    stations = np.union1d(even, inner)
    stations = stations[np.append(True, np.diff(stations) > _SAME)]
    stations[-1] = stop
    curve = Curve.hermite(np.column_stack((road.x, road.y)), road.heading, closed=road.closed)
    section = road.cross_section()
    places = stations * (curve.length / road.length)
    if road.closed and not is_loop(road):  # open at its junction
        curve, places = curve.between(places[0], places[-1]), places - places[0]
    heights = road_heights(road, stations)
    aside = section.border_offsets(stations)
    borders = np.stack([np.column_stack((_beside(curve, to, places), heights)) for to in aside])
    chosen = _chosen(borders, tolerance, np.searchsorted(stations, limits - _SAME))
    slope = np.gradient(heights, stations)
    left = curve.normal(places)
    return RoadSurface(
        road, section, stations[chosen], borders[:, chosen], left[chosen], slope[chosen]
    )


def _chosen(borders: Floats, tolerance: float, always: Integers) -> Integers:
    """The stations that borders (l, n, 3) need to be within a tolerance, and `always` those."""
    ends = [0, *always.tolist(), borders.shape[1] - 1]
    parts = [
        first + thinned(borders[:, first : last + 1], tolerance, _MOST)
        for first, last in pairwise(ends)
    ]
    return np.unique(np.concatenate(parts))


def _beside(curve: Curve, away: Floats, places: Floats) -> Floats:
    """(n, 2) points beside the curve; on a loop the last place is the first."""
    if not curve.closed:
        return offset(curve, away, places)
    line = offset(curve, away[:-1], places[:-1])
    return np.vstack((line, line[:1]))
