"""The surfaces of the lanes of a road from stretch to stretch, and of junctions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise

from .scene_junctions import SceneJunction
from .scene_road import SceneRoad
from .scene_surface import SurfaceName


@dataclass(frozen=True, slots=True)
class SurfaceStretch:
    """A stretch of a road on which each lane has one surface."""

    start: float
    """arc length along the road, meters"""
    end: float
    surfaces: tuple[SurfaceName | None, ...]
    """of the lanes from left to right; None where the road says nothing"""


def surface_stretches(road: SceneRoad, lanes: tuple[int, ...]) -> tuple[SurfaceStretch, ...]:
    """All of a road in order, at least one stretch; of patches that overlap the last one counts.
    `lanes`: the ids of its lanes from left to right."""
    ends = {0.0, road.length}
    for patch in road.surface_patches:
        ends |= {min(max(at, 0.0), road.length) for at in (patch.start, patch.end)}
    found: list[SurfaceStretch] = []
    for start, end in pairwise(sorted(ends)):
        surfaces = tuple(_surface(road, 0.5 * (start + end), lane) for lane in lanes)
        if found and found[-1].surfaces == surfaces:
            start = found.pop().start
        found.append(SurfaceStretch(start, end, surfaces))
    return tuple(found)


def junction_surface(junction: SceneJunction, roads: Mapping[str, SceneRoad]) -> SurfaceName | None:
    """That of the roads that meet at a junction, without their patches; None if they differ.
    `roads`: all of the scene, by name."""
    found = {roads[arm.road].surface for arm in junction.arms}
    return found.pop() if len(found) == 1 else None


def _surface(road: SceneRoad, station: float, lane: int) -> SurfaceName | None:
    for patch in reversed(road.surface_patches):
        if patch.start <= station <= patch.end and lane in (patch.lanes or (lane,)):
            return patch.surface
    return road.surface
