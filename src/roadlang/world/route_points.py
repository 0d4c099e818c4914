"""The points of the routes of copies, and the places in lanes that they stand for."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..evaluate.copies import CopyBatch
from ..evaluate.evaluation import evaluate
from ..geometry.arrays import Floats, Integers
from ..geometry.routes.lane_graph import LaneGraph
from ..geometry.routes.nearest_lanes import NearRoads, near_roads
from ..geometry.routes.shortest import RoutePlace
from ..ir.scenario import ScenarioActor
from ..ir.values import PassCall
from .copies import element_of
from .positions import column
from .route_positions import lane_places_of

FARTHEST = 15.0
"""Meters from the nearest lane that a point of a route may be"""


@dataclass(frozen=True, eq=False)
class NearPoints:
    """One point of the routes of copies: points that differ (n,), and which each copy (R,) has."""

    points: Floats
    which: Integers
    near: NearRoads
    lanes: LaneGraph
    _places: dict[int, tuple[RoutePlace, ...]] = field(default_factory=dict)

    def places(self, row: int) -> tuple[RoutePlace, ...]:
        """In the lanes near the point of a copy."""
        number = int(self.which[row])
        if number not in self._places:
            self._places[number] = self.near.options(self.lanes, number, lambda _: True)
        return self._places[number]

    def point(self, row: int) -> tuple[float, float]:
        """x and y, meters."""
        x, y = self.points[int(self.which[row])].tolist()
        return x, y

    def distance(self, row: int) -> float:
        """Meters from the nearest lane."""
        return float(self.near.distance[:, int(self.which[row])].min())


@dataclass(frozen=True, eq=False)
class NamedPlaces:
    """A position such as `junction(3)` in the routes of copies."""

    actor: ScenarioActor
    call: PassCall
    copies: CopyBatch
    lanes: LaneGraph

    def places(self, row: int) -> tuple[RoutePlace, ...]:
        """Those that it stands for."""
        return lane_places_of(self.actor, self.call, self.copies, row, self.lanes)


@dataclass(frozen=True, eq=False)
class RoutePoints:
    """What the routes of copies pass, in order, after their start."""

    parts: tuple[NearPoints | NamedPlaces, ...]

    def stages(self, row: int) -> list[tuple[RoutePlace, ...]]:
        """The places in lanes that a copy passes one of each."""
        return [part.places(row) for part in self.parts]

    def beyond(self, row: int) -> float:
        """Meters beyond `FARTHEST` that the worst point of a copy is from every lane."""
        points = (part for part in self.parts if isinstance(part, NearPoints))
        return max((point.distance(row) - FARTHEST for point in points), default=0.0)


def route_points(actor: ScenarioActor, copies: CopyBatch, lanes: LaneGraph) -> RoutePoints | None:
    """The points of the routes of copies; None where the route is random, or there is none.

    They are drawn once, however often a copy is placed again.
    """
    route = actor.options.get("route")
    none = np.zeros(copies.count, np.int64)
    first = copies.at_tries(none) if copies.tries.any() else copies
    value = None if route is None else evaluate(route, first, element_of(actor))
    if not isinstance(value, tuple):
        return None
    parts: list[NearPoints | NamedPlaces] = []
    for item in value:
        if isinstance(item, PassCall):
            parts.append(NamedPlaces(actor, item, first, lanes))
        else:
            parts.append(_near(np.stack([column(part, first) for part in item], axis=-1), lanes))
    return RoutePoints(tuple(parts))


def route_parts(
    actor: ScenarioActor, copies: CopyBatch, lanes: LaneGraph
) -> tuple[NearPoints | NamedPlaces, ...]:
    """Where copies begin, if that is a point or position of the network, and what they pass."""
    at = evaluate(actor.at, copies, element_of(actor))
    route = route_points(actor, copies, lanes)
    rest = () if route is None else route.parts
    if isinstance(at, PassCall):
        return (NamedPlaces(actor, at, copies, lanes), *rest)
    if isinstance(at, tuple):
        points = np.stack([column(part, copies) for part in at], axis=-1)
        return (_near(points, lanes), *rest)
    return rest


def _near(points: Floats, lanes: LaneGraph) -> NearPoints:
    single, which = np.unique(points, axis=0, return_inverse=True)
    return NearPoints(single, which.reshape(-1), near_roads(lanes, single), lanes)
