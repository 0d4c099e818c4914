"""How high the roads of a scene lie at any place."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry import Floats

from .built import built_roads
from .road_surface import road_heights

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor, SceneRoad

GROUND_BELOW = 0.05
"""Meters of the ground under the lowest road, so that neither shines through the other."""


@dataclass(frozen=True)
class SceneHeights:
    """Points (n, 2) of roads and their heights (n,); none where the scene is level."""

    _roads: Mapping[str, SceneRoad]
    _points: Floats
    _heights: Floats

    @classmethod
    def of(cls, scene: Scene) -> SceneHeights:
        """Of the roads that are built."""
        roads = {road.name: road for road in built_roads(scene) if any(road.elevation)}
        points = [np.column_stack((road.x, road.y)) for road in roads.values()]
        heights = [np.array(road.elevation) for road in roads.values()]
        return cls(
            roads,
            np.concatenate(points) if points else np.empty((0, 2)),
            np.concatenate(heights) if heights else np.empty(0),
        )

    def at(self, points: Floats) -> Floats:
        """(m,) heights of the road nearest to each of the points (m, 2), meters."""
        if not len(self._heights):
            return np.zeros(len(points))
        from scipy.spatial import cKDTree

        _, nearest = cKDTree(self._points).query(points)
        return np.asarray(self._heights[nearest])

    def at_actor(self, actor: SceneActor) -> float:
        """That of the road that it stands on, else of the nearest."""
        road = self._roads.get(actor.road or "")
        if road is not None and actor.start is not None:
            return float(road_heights(road, np.array([actor.start]))[0])
        return float(self.at(np.array([[actor.x, actor.y]]))[0])
