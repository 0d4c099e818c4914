"""Routes: places in lanes, and the parts of lanes that lead from one to the next."""

from __future__ import annotations

from dataclasses import dataclass

from .lane_graph import LaneGraph, Turn

CHANGE_COST = 30.0
"""Meters of detour that a change of lane is worth"""
ONWARD = 2_000.0
"""Meters that a route leads on where nothing says how far"""


@dataclass(frozen=True, slots=True)
class RoutePlace:
    """A place in a lane of a graph: an arc length of the edge; `penalty` is what it costs to choose
    it among others, in meters."""

    lane: int
    station: float
    penalty: float = 0.0


@dataclass(frozen=True, slots=True)
class Leg:
    """A part of one lane, from arc length `start` to `stop` of its edge, and the turn at its end,
    None at the last one and before a change of lane."""

    lane: int
    start: float
    stop: float
    turn: Turn | None = None


@dataclass(frozen=True, slots=True)
class PlannedRoute:
    """Legs in order, and what they cost: meters, changes of lane and penalties."""

    legs: tuple[Leg, ...]
    cost: float
    closed: bool = False


def lane_legs(
    graph: LaneGraph, first: int, last: int, start: float, stop: float, turn: Turn | None
) -> tuple[Leg, ...]:
    """Along one road, the changes of lane evenly between."""
    lanes = graph.lanes_between(first, last)
    cuts = [start + (stop - start) * k / len(lanes) for k in range(len(lanes))] + [stop]
    legs = [Leg(lane, cuts[k], cuts[k + 1]) for k, lane in enumerate(lanes)]
    return (*legs[:-1], Leg(lanes[-1], cuts[-2], cuts[-1], turn))
