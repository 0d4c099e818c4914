"""The routes of placed agents through their network."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...evaluate.candidates import CandidateBatch
from ...evaluate.copies import CopyBatch
from ...geometry.routes.lane_graph import LaneGraph, TravelLane
from ...geometry.routes.legs import ONWARD, PlannedRoute, RoutePlace
from ...geometry.routes.next_turns import NextTurn
from ...geometry.routes.random_routes import random_route
from ...geometry.routes.shortest import Stage, shortest_route
from ...geometry.routes.walking import following_legs, straight_route
from ...ir.placed_batch import PlacedBatch
from ...ir.scenario import ScenarioActor
from ..networks.lane_graphs import lanes_of_network
from ..roads.road_places import to_root
from .actor_numbers import number_of_copies
from .copies import kinds_of
from .positions import Others, names_another, other_of_copies
from .route_points import route_points
from .spots import Spots
from .turning import sharpest_turn

PASSED = 30.0
"""Meters behind the start at which the first point of a route may lie."""


def has_route(actor: ScenarioActor, candidates: CandidateBatch) -> bool:
    """Whether an agent has a route: a written or random one, or, where it drives and is placed by
    another, the way of that."""
    scenario = candidates.scenario
    if actor.on not in scenario.networks or actor.name not in scenario.agents:
        return False
    return "route" in actor.options or (bool(actor.drive) and names_another(actor, scenario))


def routes_of(actor: ScenarioActor, candidates: CandidateBatch, others: Others) -> NDArray[Any]:
    """(V, N) the `PlannedRoute` of every copy of an agent, by arc lengths of the roots of its
    roads; None of a copy without route. `others` says where agents and objects were placed."""

    def make() -> NDArray[Any]:
        where = others(actor)
        found = np.full(where.x.shape, None, dtype=object)
        if has_route(actor, candidates) and where.x.size:
            _plan(actor, candidates, others, found)
        return found

    return candidates.once(("routes", actor.name), make, inherited=False)


def leading_routes(
    actor: ScenarioActor, copies: CopyBatch, others: Others
) -> list[PlannedRoute | None] | None:
    """(R) the routes of the agent that copies are placed by; None where it has none."""
    other, _ = other_of_copies(actor, copies, 1)
    if not has_route(other, copies.candidates):
        return None
    routes = routes_of(other, copies.candidates, others)
    if routes.shape[1] == 0:
        return None
    _, numbers = other_of_copies(actor, copies, routes.shape[1])
    found: list[PlannedRoute | None] = routes[copies.rows, numbers].tolist()
    return found


def _plan(
    actor: ScenarioActor, candidates: CandidateBatch, others: Others, into: NDArray[Any]
) -> None:
    network = candidates.scenario.networks[str(actor.on)]
    lanes, where = lanes_of_network(network, candidates), others(actor)
    copies = CopyBatch.every(candidates, where.x.shape[1])
    starts = start_places(actor, where, lanes, copies)
    points = route_points(actor, copies, lanes)
    numbers = number_of_copies(actor, "route", copies, 0.0) if points is None else None
    lengths = number_of_copies(actor, "route_length", copies, ONWARD)
    leads = leading_routes(actor, copies, others) if "route" not in actor.options else None
    if candidates.record is not None:
        copies.record_in(candidates.record)
    kinds = kinds_of(actor, candidates)
    present = where.present.astype(bool).reshape(-1)
    for row in np.flatnonzero(present).tolist():
        start = starts[row]
        if start is None:
            continue
        route: PlannedRoute | int | None
        if points is not None:
            route = route_through(lanes, start, points.stages(row))
        elif "route" in actor.options:
            assert numbers is not None
            bend = sharpest_turn(kinds.instances[row].kind)
            route = random_route(lanes, start, float(lengths[row]), float(numbers[row]), bend)
        else:
            lead = leads[row] if leads is not None else None
            route = _after(lanes, start, lead)
        into.reshape(-1)[row] = route if isinstance(route, PlannedRoute) else None


def route_through(lanes: LaneGraph, start: RoutePlace, stages: list[Stage]) -> PlannedRoute | int:
    """The route by all stages, or the number of the first one that no way leads to, from 1. A first
    place that lies just behind the start in its lane has been passed already."""
    found = shortest_route(lanes, (start,), stages)
    if isinstance(found, PlannedRoute):
        return found
    first = () if isinstance(stages[0], NextTurn) else stages[0]
    is_passed = len(stages) > 1 and any(
        place.lane == start.lane and abs(place.station - start.station) < PASSED for place in first
    )
    if not is_passed:
        return found
    onward = shortest_route(lanes, (start,), stages[1:])
    return onward if isinstance(onward, PlannedRoute) else onward + 1


def _after(lanes: LaneGraph, start: RoutePlace, lead: PlannedRoute | None) -> PlannedRoute:
    """The way of another from one's own place; straight on, where it has none."""
    if lead is not None:
        legs = following_legs(lanes, start, lead)
        passed = [(RoutePlace(leg.lane, leg.stop),) for leg in legs if leg.turn is not None]
        last = (RoutePlace(legs[-1].lane, legs[-1].stop),)
        found = shortest_route(lanes, (start,), [*passed, last])
        if isinstance(found, PlannedRoute):
            return found
    return straight_route(lanes, start, ONWARD)


def start_places(
    actor: ScenarioActor, where: PlacedBatch | Spots, lanes: LaneGraph, copies: CopyBatch
) -> list[RoutePlace | None]:
    """(R) where copies stand, by arc length of the root; None of one in no lane."""
    road, lane, backward = (
        getattr(where, name).reshape(-1).tolist() for name in ("road", "lane", "backward")
    )
    start, station = where.start.reshape(-1), np.zeros(copies.count)
    for edge in set(road):
        chosen = np.flatnonzero(np.array(road) == edge)
        name, rows = f"{actor.on}/{edge}", copies.rows[chosen]
        station[chosen] = to_root(name, copies.candidates, rows, start[chosen])
    numbers = {lane: number for number, lane in enumerate(lanes.lanes)}
    keys = [TravelLane(*parts) for parts in zip(road, lane, backward, strict=True)]
    if "route" in actor.options and "lane" in actor.options:
        keys = [_beside(lanes, key) if key not in numbers else key for key in keys]
    return [
        RoutePlace(numbers[key], float(station[row])) if key in numbers else None
        for row, key in enumerate(keys)
    ]


def _beside(lanes: LaneGraph, place: TravelLane) -> TravelLane:
    """The lane for vehicles that is nearest to another, such as a sidewalk, in its direction."""
    same = [lanes.lanes[number] for number in lanes.of_edge.get(place.edge, ())]
    same = [lane for lane in same if lane.backward == place.backward] if place.lane else []
    return min(same, key=lambda lane: (abs(lane.lane - place.lane), lane.lane), default=place)
