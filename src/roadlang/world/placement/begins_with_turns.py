"""The lanes of a network from which copies can make the turns of their routes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ...geometry.arrays import Integers
from ...geometry.routes.lane_graph import LaneGraph
from ...geometry.routes.legs import PlannedRoute, RoutePlace
from ...geometry.routes.next_turns import NextTurn
from ...geometry.routes.shortest import shortest_route
from .route_points import RoutePoints, TurnWords


def begins_with_turns(
    lanes: LaneGraph, allowed: Sequence[int], route: RoutePoints | None, index: Integers
) -> Iterator[tuple[Sequence[int], Integers]]:
    """Of copies at `index` (n,), which of the `allowed` lanes lead on as their routes turn, and
    which of the copies (positions in `index`) have these: all lanes, where nothing is said of
    turns alone, or none leads on."""
    if route is None or not all(isinstance(part, TurnWords) for part in route.parts):
        yield allowed, np.arange(len(index))
        return
    said: dict[tuple[NextTurn, ...], list[int]] = {}
    for position, row in enumerate(index.tolist()):
        turns = tuple(part.turn(row) for part in route.parts if isinstance(part, TurnWords))
        said.setdefault(turns, []).append(position)
    for turns, positions in said.items():
        leading = [lane for lane in allowed if leads_on(lanes, [lane], turns)]
        yield leading or allowed, np.array(positions)


def leads_on(lanes: LaneGraph, begins: Sequence[int], turns: Sequence[NextTurn]) -> bool:
    """Whether some of these lanes lead to all turns in order."""
    places = [RoutePlace(lane, lanes.begin[lane]) for lane in begins]
    return isinstance(shortest_route(lanes, places, turns), PlannedRoute)
