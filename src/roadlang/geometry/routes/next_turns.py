"""The turns at the next junction on one's way: left, straight on, right, or around."""

from __future__ import annotations

import heapq
import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import count
from typing import TypeAlias

import numpy as np

from .lane_graph import Exit, LaneGraph
from .legs import CHANGE_COST, Leg, RoutePlace, lane_legs

STRAIGHT = math.radians(45.0)
"""Ways out of a roundabout whose heading differs less from the way in lead straight on."""

Entry: TypeAlias = tuple[int, float] | None
"""The road on which a roundabout is entered, and the heading there; None outside of one"""


@dataclass(frozen=True, slots=True)
class NextTurn:
    """A stage of a route: how it leaves the next junction, "left", "straight", "right" or "u". A
    roundabout is one junction; a place where two roads go on in one another is none."""

    turn: str


@dataclass(frozen=True, slots=True)
class Way:
    """From a place through the next junction, to where the road beyond is entered."""

    turn: str
    legs: tuple[Leg, ...]
    end: RoutePlace
    cost: float


@dataclass(frozen=True, slots=True)
class _Reached:
    place: RoutePlace
    legs: tuple[Leg, ...]
    cost: float
    entry: Entry = None


def ways_on(graph: LaneGraph, place: RoutePlace) -> tuple[Way, ...]:
    """All ways through the next junction, the cheapest into each lane, cheapest first."""
    numbers = count()
    waiting = [(0.0, next(numbers), _Reached(place, (), 0.0))]
    entered: set[tuple[int, bool]] = set()
    found: dict[int, Way] = {}
    while waiting:
        _, _, reached = heapq.heappop(waiting)
        for after, turn in _steps(graph, reached):
            lane = after.place.lane
            if turn is not None:
                if lane not in found or after.cost < found[lane].cost:
                    found[lane] = Way(turn, after.legs, after.place, after.cost)
            elif (lane, after.entry is None) not in entered:
                entered.add((lane, after.entry is None))
                heapq.heappush(waiting, (after.cost, next(numbers), after))
    return tuple(sorted(found.values(), key=lambda way: (way.cost, way.end.lane)))


def _steps(graph: LaneGraph, reached: _Reached) -> Iterator[tuple[_Reached, str | None]]:
    """Through the next junction of the graph, and what the turn is, where it ends the way."""
    lane, station = reached.place.lane, reached.place.station
    room = graph.room(lane, station)
    for exit_ in graph.exits(lane, room):
        target = exit_.turn.target
        entry = _entry(graph, reached, exit_)
        after = _Reached(
            RoutePlace(target, graph.begin[target]),
            reached.legs
            + lane_legs(graph, lane, exit_.lane, station, graph.end[exit_.lane], exit_.turn),
            reached.cost + max(room, 0.0) + CHANGE_COST * exit_.changes + exit_.turn.length,
            entry,
        )
        goes_on = exit_.turn.junction in graph.joints or is_in_ring(graph, target)
        yield after, None if goes_on else _turn_out(graph, reached, exit_)


def is_in_ring(graph: LaneGraph, lane: int) -> bool:
    """Whether a lane of the graph is that of a roundabout."""
    return graph.lanes[lane].edge in graph.ring


def _entry(graph: LaneGraph, reached: _Reached, exit_: Exit) -> Entry:
    if not is_in_ring(graph, exit_.turn.target):
        return None
    if is_in_ring(graph, exit_.lane):
        return reached.entry
    return graph.lanes[exit_.lane].edge, graph.heading(exit_.lane, graph.end[exit_.lane])


def _turn_out(graph: LaneGraph, reached: _Reached, exit_: Exit) -> str:
    """Of the whole roundabout, where one is left that had been entered."""
    if reached.entry is None:
        return exit_.turn.turn
    edge, heading = reached.entry
    target = exit_.turn.target
    if graph.lanes[target].edge == edge:
        return "u"
    turned = graph.heading(target, graph.begin[target]) - heading
    turned = float(np.angle(np.exp(1j * turned)))
    return "straight" if abs(turned) < STRAIGHT else "left" if turned > 0.0 else "right"
