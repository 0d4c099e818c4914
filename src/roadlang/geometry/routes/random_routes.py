"""Random routes, turn by turn."""

from __future__ import annotations

import math

from .lane_graph import Exit, LaneGraph
from .legs import Leg, PlannedRoute, RoutePlace, lane_legs

_TURNS_PER_NUMBER = 12
_SCRAMBLE = 0.6180339887498949
_LARGE = 8191.0
_LAST = 20.0
"""Meters that are driven at least beyond the last turn"""
_MOST_TURNS = 10_000


def random_route(
    graph: LaneGraph,
    origin: RoutePlace,
    length: float,
    number: float,
    sharpest: float = math.inf,
) -> PlannedRoute:
    """From a place on, until `length` meters are driven, the lanes end, or all turns, or the lanes
    that they lead into, bend more than `sharpest`, 1/m.

    All roads that can be turned into are equally likely. `number` in [0, 1) decides: its leading
    digits the first turn, those after it the next, so that close numbers begin alike.
    """
    legs: list[Leg] = []
    lane, station, left = origin.lane, origin.station, length
    digits, turns, is_last = number, 0, False
    while True:
        room = graph.room(lane, station)
        options = _options(graph, lane, room, sharpest)
        if room >= left or is_last or not options or turns == _MOST_TURNS:
            step = min(room, left) * (1.0 if graph.forward(lane) else -1.0)
            legs.append(Leg(lane, station, station + step))
            return PlannedRoute(tuple(legs), length)
        if turns and turns % _TURNS_PER_NUMBER == 0:
            digits = (number * _LARGE + turns * _SCRAMBLE) % 1.0
        share = digits * len(options)
        chosen = options[min(int(share), len(options) - 1)]
        digits, turns = share - int(share), turns + 1
        legs += lane_legs(graph, lane, chosen.lane, station, graph.end[chosen.lane], chosen.turn)
        left -= room + chosen.turn.length
        lane = chosen.turn.target
        station = graph.begin[lane]
        is_last = left <= _LAST  # however short the lane: all lanes of a ring may be shorter
        left = max(left, _LAST)  # it does not end in a junction


def _options(graph: LaneGraph, lane: int, room: float, sharpest: float) -> list[Exit]:
    """The turns to choose from: one into each road, with the fewest changes of lane; back the way
    one came only where there is no other."""
    found: dict[tuple[int, bool], Exit] = {}
    for exit_ in sorted(
        graph.exits(lane, room),
        key=lambda item: (item.changes, item.turn.junction, item.turn.connection),
    ):
        target = graph.lanes[exit_.turn.target]
        found.setdefault((target.edge, target.backward), exit_)
    onward = [exit_ for exit_ in found.values() if exit_.turn.turn != "u"]
    options = onward or list(found.values())
    if sharpest < math.inf:
        options = [item for item in options if _sharpest(graph, item) <= sharpest]
    return sorted(options, key=lambda item: (item.turn.junction, item.turn.connection))


def _sharpest(graph: LaneGraph, exit_: Exit) -> float:
    return max(exit_.turn.curvature, graph.sharpest_bend(exit_.turn.target))
