"""The area of a junction as triangles in space."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry import Floats, Integers, triangulated

from .built import built_junctions
from .road_surface import road_heights

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneArm, SceneJunction, SceneRoad


@dataclass(frozen=True)
class JunctionSurface:
    """`ring` (n, 3) runs counter-clockwise, `triangles` (t, 3) are indices of its points."""

    name: str
    junction: SceneJunction
    ring: Floats
    triangles: Integers


def junction_surfaces(scene: Scene) -> Iterator[JunctionSurface]:
    """The areas of the junctions that are built, at the heights of the roads that enter them."""
    roads = {road.name: road for road in scene.roads}
    for network, junction in built_junctions(scene):
        ring = np.array(junction.area)
        if len(ring) < 3:
            continue
        raised = np.column_stack((ring, _heights(ring, junction, roads)))
        name = f"{network}/junction {junction.id}"
        yield JunctionSurface(name, junction, raised, triangulated(ring))


def arm_height(arm: SceneArm, roads: dict[str, SceneRoad]) -> float:
    """Where its road begins, meters."""
    road = roads[arm.road]
    at = road.trim[0] if arm.end == "start" else road.length - road.trim[1]
    return float(road_heights(road, np.array([at]))[0])


def _heights(ring: Floats, junction: SceneJunction, roads: dict[str, SceneRoad]) -> Floats:
    """(n,) those of the roads at their corners, and between corners in proportion."""
    known: dict[int, float] = {}
    for arm in junction.arms:
        known |= dict.fromkeys((arm.left, arm.right), arm_height(arm, roads))
    if not any(known.values()):
        return np.zeros(len(ring))
    steps = np.hypot(*(np.roll(ring, -1, axis=0) - ring).T)
    along = np.concatenate(([0.0], np.cumsum(steps)))
    places = sorted(known)
    heights = [known[place] for place in places]
    return np.interp(along[:-1], along[places], heights, period=float(along[-1]))
