"""The bends along a route, of roads and of turns."""

from __future__ import annotations

import math

import numpy as np

from ...evaluate.candidates import CandidateBatch
from ...geometry.arrays import Floats
from ...geometry.networks.junction_model import Connection
from ...geometry.routes.legs import Leg, PlannedRoute
from ..networks.lane_graphs import lanes_of_network
from ..networks.networks import network_root
from .named_roads import named_road
from .road_places import from_root

_FARTHEST = 400.0
"""Meters ahead that decide how fast an agent may begin"""

_REACHES_OVER = 6.0
"""Meters before the middle of a lane change from which on one is in both lanes."""


def bends_of_route(
    route: PlannedRoute | None, network: str, candidates: CandidateBatch
) -> tuple[Floats, Floats, float]:
    """Meters ahead (n,), and the curvature there, of a single candidate; of the center lines of
    roads, and of connections at both ends of each piece. And meters to the first place where an
    agent may have to stop, infinite for none: where its lane ends at a junction, or is changed.
    """
    source = candidates.scenario.networks[network]
    lanes = lanes_of_network(source, candidates)
    plan = network_root(source, candidates).junctions.plans[network]
    connections = {
        (junction.id, connection.id): connection
        for junction in plan.junctions
        for connection in junction.connections
    }
    kinds = {junction.id: junction.kind for junction in plan.junctions}
    ahead, curvature, driven, stop = [np.zeros(0)], [np.zeros(0)], 0.0, math.inf
    legs = route.legs if route is not None else ()
    for number, leg in enumerate(legs):
        if driven > _FARTHEST:
            break
        name = f"{network}/{lanes.lanes[leg.lane].edge}"
        places, bends, length = _of_leg(name, leg, candidates)
        ahead.append(driven + places)
        curvature.append(bends)
        driven += length
        turn = None if leg.turn is None else connections.get(_key(leg))
        if leg.turn is None and number + 1 < len(legs):
            stop = min(stop, driven - _REACHES_OVER)
        if turn is not None:
            if kinds[_key(leg)[0]] != "joint":
                stop = min(stop, driven)
            places, bends = _of_turn(turn)
            ahead.append(driven + places)
            curvature.append(bends)
            driven += turn.length
    return np.concatenate(ahead), np.concatenate(curvature), stop


def _key(leg: Leg) -> tuple[int, int]:
    assert leg.turn is not None
    return leg.turn.junction, leg.turn.connection


def _of_leg(name: str, leg: Leg, candidates: CandidateBatch) -> tuple[Floats, Floats, float]:
    """Meters from its beginning, curvature there, and its length."""
    road = named_road(name, candidates)
    rows = np.zeros(2, np.intp)
    start, stop = from_root(name, candidates, rows, np.array([leg.start, leg.stop])).tolist()
    steps = np.hypot(*np.diff(road.points[0], axis=0).T)
    arc = np.concatenate([[0.0], np.cumsum(steps)])
    along = arc - start if stop >= start else start - arc
    length = abs(stop - start)
    inside = (along >= 0.0) & (along <= length)
    return along[inside], road.curvature[0][inside], length


def _of_turn(turn: Connection) -> tuple[Floats, Floats]:
    lengths = np.array([length for length, _ in turn.pieces])
    begins = np.concatenate([[0.0], np.cumsum(lengths)])[:-1]
    return begins, np.array([curvature for _, curvature in turn.pieces])
