"""Which roads of a scene are drawn in full, which as a ghost, which as pale context."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneRoad


@dataclass(frozen=True)
class Selection:
    """Names of roads, in the scene's order."""

    full: tuple[str, ...]
    ghosts: tuple[str, ...]
    context: tuple[str, ...]


def select(scene: Scene) -> Selection:
    """Derived roads in full; the roots of what differs from them as ghosts; the rest as context."""
    roads = {road.name: road for road in scene.roads}
    full = [road for road in scene.roads if road.derived] or list(scene.roads)
    names = {road.name for road in full}
    roots = {
        road.root
        for road in full
        if road.root in roads and road.root not in names and _differ(road, roads[road.root])
    }
    rest = [name for name in roads if name not in names and name not in roots]
    return Selection(
        full=tuple(road.name for road in full),
        ghosts=tuple(name for name in roads if name in roots),
        context=tuple(name for name in rest if roads[name].network is not None),
    )


def _differ(road: SceneRoad, root: SceneRoad) -> bool:
    return (road.x, road.y) != (root.x, root.y)
