"""The points and turns of the routes of copies, and the places in lanes that they stand for."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from ...evaluate.copies import CopyBatch
from ...evaluate.evaluation import evaluate
from ...geometry.arrays import Floats, Integers
from ...geometry.routes.lane_graph import LaneGraph
from ...geometry.routes.legs import RoutePlace
from ...geometry.routes.nearest_lanes import NearRoads, near_roads
from ...geometry.routes.next_turns import NextTurn
from ...geometry.routes.shortest import Stage
from ...ir.scenario import ScenarioActor
from ...ir.values import PassCall
from .actor_numbers import column
from .copies import element_of
from .route_positions import lane_places_of

TURNS = {"left": "left", "straight": "straight", "right": "right", "turn_around": "u"}
"""The words of routes for turns, and how connections name them"""
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
class TurnWords:
    """A turn at the next junction in the routes of copies: a word (R,)."""

    words: NDArray[np.object_]

    def word(self, row: int) -> str:
        """As it is written."""
        return str(self.words[row])

    def turn(self, row: int) -> NextTurn:
        """As connections name it."""
        return NextTurn(TURNS[self.word(row)])


Part: TypeAlias = NearPoints | NamedPlaces | TurnWords


def stage_of(part: Part, row: int) -> Stage:
    """What the route of a copy passes there."""
    return part.turn(row) if isinstance(part, TurnWords) else part.places(row)


@dataclass(frozen=True, eq=False)
class RoutePoints:
    """What the routes of copies pass, in order, after their start."""

    parts: tuple[Part, ...]

    def stages(self, row: int) -> list[Stage]:
        """What a copy passes one of each."""
        return [stage_of(part, row) for part in self.parts]

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
    parts: list[Part] = []
    for item in value:
        if isinstance(item, str | np.ndarray):
            parts.append(TurnWords(np.broadcast_to(np.ravel(item), (copies.count,))))
        elif isinstance(item, PassCall):
            parts.append(NamedPlaces(actor, item, first, lanes))
        else:
            parts.append(_near(np.stack([column(part, first) for part in item], axis=-1), lanes))
    return RoutePoints(tuple(parts))


def route_parts(actor: ScenarioActor, copies: CopyBatch, lanes: LaneGraph) -> tuple[Part, ...]:
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
