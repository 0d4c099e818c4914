"""The points of the routes of copies, and the places in lanes near them."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..evaluate.copies import CopyBatch
from ..evaluate.evaluation import evaluate
from ..geometry.arrays import Floats, Integers
from ..geometry.routes.lane_graph import LaneGraph
from ..geometry.routes.nearest_lanes import NearRoads, near_roads
from ..geometry.routes.shortest import LanePlace
from ..ir.scenario import ScenarioActor
from ..ir.values import Items
from .copies import element_of
from .positions import column

FARTHEST = 15.0
"""Meters from the nearest lane that a point of a route may be"""


@dataclass(eq=False)
class RoutePoints:
    """The points (R, K, 2) that copies pass, in order, after their start."""

    points: Floats
    _near: list[tuple[NearRoads, Integers]] = field(default_factory=list)
    _stages: dict[tuple[int, ...], list[tuple[LanePlace, ...]]] = field(default_factory=dict)

    def stages(self, lanes: LaneGraph, row: int) -> list[tuple[LanePlace, ...]]:
        """The places in lanes near the points of a copy."""
        key = tuple(int(which[row]) for _, which in self._found(lanes))
        if key not in self._stages:
            self._stages[key] = [
                near.options(lanes, number, lambda _: True)
                for number, (near, _) in zip(key, self._near, strict=True)
            ]
        return self._stages[key]

    def beyond(self, lanes: LaneGraph, row: int) -> float:
        """Meters beyond `FARTHEST` that the worst point of a copy is from every lane."""
        distances = [
            float(near.distance[:, which[row]].min()) for near, which in self._found(lanes)
        ]
        return max(0.0, max(distances, default=0.0) - FARTHEST)

    def _found(self, lanes: LaneGraph) -> list[tuple[NearRoads, Integers]]:
        if not self._near:
            for number in range(self.points.shape[1]):
                single, which = np.unique(self.points[:, number], axis=0, return_inverse=True)
                self._near.append((near_roads(lanes, single), which.reshape(-1)))
        return self._near


def route_points(actor: ScenarioActor, copies: CopyBatch) -> RoutePoints | None:
    """The points of the routes of copies; None where the route is random, or there is none.

    They are drawn once, however often a copy is placed again.
    """
    route = actor.options.get("route")
    none = np.zeros(copies.count, np.int64)
    first = copies.at_tries(none) if copies.tries.any() else copies
    value = None if route is None else evaluate(route, first, element_of(actor))
    if not isinstance(value, tuple):
        return None
    columns = [[column(part, copies) for part in point] for point in value]
    points = [np.stack(point, axis=-1) for point in columns]
    return RoutePoints(np.stack(points, axis=1))


def has_points(actor: ScenarioActor) -> bool:
    """Whether the route of an agent leads through points."""
    return isinstance(actor.options.get("route"), Items)
