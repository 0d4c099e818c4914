"""The shortest routes by places in lanes and turns: Dijkstra's algorithm over lanes."""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

from .lane_graph import LANE_CHANGE, LaneGraph, Turn
from .legs import CHANGE_COST, ONWARD, Leg, PlannedRoute, RoutePlace, lane_legs
from .next_turns import NextTurn, ways_on
from .walking import straight_route

Stage: TypeAlias = Sequence[RoutePlace] | NextTurn
"""What a route passes: one of several places, or the next junction by a turn"""

BEGINS_NEAR = 1.001
"""Times the penalty of where a route begins: of routes that cost the same, that one is taken which
begins nearest to its first point, whichever way the lanes are counted."""
ROOM_TO_BEGIN = 12.0
"""Meters of a lane that is long enough for an agent to begin in, where there are such"""


@dataclass(frozen=True, slots=True)
class _Tree:
    """From where traffic enters one lane: the cost to enter each, and how."""

    cost: dict[int, float]
    before: dict[int, tuple[int, int, Turn]]
    """the lane entered before, the one left, and the turn between"""


@dataclass(frozen=True, slots=True)
class _Path:
    """The path from one place to another: into the lane left first, by the turn there, and on."""

    cost: float
    exit_lane: int = -1
    turn: Turn | None = None
    entered: int = -1
    """the lane of the last road as it is entered"""


@dataclass(frozen=True, slots=True)
class _Reached:
    place: RoutePlace
    cost: float
    legs: tuple[Leg, ...]


def shortest_route(
    graph: LaneGraph, begins: Sequence[RoutePlace], stages: Sequence[Stage]
) -> PlannedRoute | int:
    """The cheapest route that begins at one place, and passes all stages in order. After a turn
    that comes last it goes straight on, until it would drive in a lane again.

    Where there is none, the number of the first stage that cannot be reached, from 1.
    """
    reached = [_Reached(place, BEGINS_NEAR * place.penalty, ()) for place in begins]
    for number, stage in enumerate(stages, 1):
        if isinstance(stage, NextTurn):
            following = _turned(graph, reached, stage.turn)
        else:
            following = [found for place in stage if (found := _nearest(graph, reached, place))]
        if not following:
            return number
        reached = following
    best = min(reached, key=lambda item: item.cost)
    last, legs = best.place, best.legs
    if stages and isinstance(stages[-1], NextTurn):
        legs += _once_around(straight_route(graph, last, ONWARD).legs)
    legs = _joined(legs)
    returns = len(stages) > 1 and any(
        place.lane == last.lane and abs(place.station - last.station) < 1e-6 for place in begins
    )
    closed = returns and legs[0].lane == last.lane and abs(legs[0].start - last.station) < 1e-6
    return PlannedRoute(legs, best.cost, closed)


def _once_around(legs: Sequence[Leg]) -> tuple[Leg, ...]:
    """The legs up to where they come back to the lane of an earlier one: nobody goes on round a
    ring, or a block, that no straight way leaves."""
    lanes = [leg.lane for leg in legs]
    count = next((n for n, lane in enumerate(lanes) if lane in lanes[:n]), len(legs))
    return (*legs[: count - 1], replace(legs[count - 1], turn=None))


def _turned(graph: LaneGraph, reached: Sequence[_Reached], turn: str) -> list[_Reached]:
    """Beyond the next junction, the cheapest way into each lane."""
    found: dict[int, _Reached] = {}
    for item in reached:
        for way in ways_on(graph, item.place):
            cost = item.cost + way.cost
            if way.turn == turn and (way.end.lane not in found or cost < found[way.end.lane].cost):
                found[way.end.lane] = _Reached(way.end, cost, item.legs + way.legs)
    return [found[lane] for lane in sorted(found)]


def _nearest(graph: LaneGraph, reached: Sequence[_Reached], place: RoutePlace) -> _Reached | None:
    best: tuple[float, _Reached, _Path] | None = None
    for item in reached:
        path = _cheapest(graph, item.place, place)
        if path is not None and (best is None or item.cost + path.cost < best[0]):
            best = item.cost + path.cost, item, path
    if best is None:
        return None
    cost, item, path = best
    legs = item.legs + _legs(graph, item.place, place, path)
    return _Reached(place, cost + place.penalty, legs)


def _cheapest(graph: LaneGraph, origin: RoutePlace, goal: RoutePlace) -> _Path | None:
    """The cheapest path between two places."""
    best: _Path | None = None
    direct = _within_road(graph, origin.lane, origin.station, goal)
    if direct is not None:
        best = _Path(direct)
    for exit_ in graph.exits(origin.lane, graph.room(origin.lane, origin.station)):
        start_cost = graph.room(origin.lane, origin.station) + CHANGE_COST * exit_.changes
        start_cost += exit_.turn.length
        tree = _tree(graph, exit_.turn.target)
        for lane in graph.carriageways[goal.lane]:
            arriving = _within_road(graph, lane, graph.begin[lane], goal)
            if lane in tree.cost and arriving is not None:
                cost = start_cost + tree.cost[lane] + arriving
                if best is None or cost < best.cost:
                    best = _Path(cost, exit_.lane, exit_.turn, lane)
    return best


def _within_road(graph: LaneGraph, lane: int, station: float, goal: RoutePlace) -> float | None:
    """The cost from a place to a goal ahead on the same road; None where it is not."""
    if goal.lane not in graph.changes[lane]:
        return None
    ahead = goal.station - station if graph.forward(lane) else station - goal.station
    changes = graph.changes[lane][goal.lane]
    if ahead < -1e-9 or changes > int(ahead // LANE_CHANGE):
        return None
    return ahead + CHANGE_COST * changes


def _tree(graph: LaneGraph, source: int) -> _Tree:
    return graph.searched(source, _searched)


def _searched(graph: LaneGraph, source: int) -> _Tree:
    cost, before = {source: 0.0}, {}
    waiting, settled = [(0.0, source)], set()
    while waiting:
        spent, lane = heapq.heappop(waiting)
        if lane in settled:
            continue
        settled.add(lane)
        length = graph.length(lane)
        for exit_ in graph.exits(lane, length):
            total = spent + length + CHANGE_COST * exit_.changes + exit_.turn.length
            target = exit_.turn.target
            if target not in cost or total < cost[target]:
                cost[target] = total
                before[target] = (lane, exit_.lane, exit_.turn)
                heapq.heappush(waiting, (total, target))
    return _Tree(cost, before)


def _legs(graph: LaneGraph, origin: RoutePlace, goal: RoutePlace, route: _Path) -> tuple[Leg, ...]:
    if route.turn is None:
        return lane_legs(graph, origin.lane, goal.lane, origin.station, goal.station, None)
    tree = _tree(graph, route.turn.target)
    passed: list[tuple[Leg, ...]] = []
    lane = route.entered
    while lane != route.turn.target:
        entered, left, turn = tree.before[lane]
        passed.append(lane_legs(graph, entered, left, graph.begin[entered], graph.end[left], turn))
        lane = entered
    last = lane_legs(
        graph, route.entered, goal.lane, graph.begin[route.entered], goal.station, None
    )
    first = lane_legs(
        graph, origin.lane, route.exit_lane, origin.station, graph.end[route.exit_lane], route.turn
    )
    return (*first, *(leg for part in reversed(passed) for leg in part), *last)


def _joined(legs: Sequence[Leg]) -> tuple[Leg, ...]:
    """Legs of one lane that follow each other as one, without those of no length."""
    found: list[Leg] = []
    for leg in legs:
        before = found[-1] if found else None
        if before is not None and before.turn is None and before.lane == leg.lane:
            found[-1] = Leg(leg.lane, before.start, leg.stop, leg.turn)
        else:
            found.append(leg)
    return tuple(found)
