"""What is wrong with a place or route in a network that no draw has a say in."""

from __future__ import annotations

import numpy as np

from ...diagnostics import Code, Diagnostic, Span, diagnose
from ...evaluate.candidates import CandidateBatch
from ...evaluate.copies import CopyBatch
from ...geometry.routes.lane_graph import LaneGraph
from ...geometry.routes.legs import PlannedRoute, RoutePlace
from ...geometry.routes.next_turns import NextTurn
from ...geometry.routes.shortest import Stage, shortest_route
from ...ir.scenario import ScenarioActor
from ..networks.lane_graphs import lanes_of_network
from .lane_choices import allowed_lanes, lane_choices
from .placement import placed
from .positions import names_another
from .road_poses import WrittenPlace
from .route_points import (
    FARTHEST,
    TURNS,
    NearPoints,
    Part,
    TurnWords,
    route_parts,
    route_points,
    stage_of,
)
from .routes import route_through, start_places


def route_fault(actor: ScenarioActor, candidates: CandidateBatch) -> Diagnostic | None:
    """RL617 for a point of an agent or object that is far from every lane of its network, RL618 for
    one that no way leads to; None where all is well in the first candidate."""
    network = candidates.scenario.networks[str(actor.on)]
    lanes = lanes_of_network(network, candidates)
    copies = CopyBatch(candidates, np.zeros(1, np.intp), np.ones(1, np.int64))
    by_another = names_another(actor, candidates.scenario)
    if by_another:
        points = route_points(actor, copies, lanes)
        parts: tuple[Part, ...] = () if points is None else points.parts
    else:
        parts = route_parts(actor, copies, lanes)
    for part in parts:
        if isinstance(part, NearPoints) and part.distance(0) > FARTHEST:
            return _far(actor, part, parts.index(part) + by_another, lanes)
    if by_another:
        return _no_way_from_there(actor, candidates, lanes)
    choice = lane_choices(actor, copies, WrittenPlace.of(actor, copies), lanes)[0]
    first = parts[0] if parts else None
    if len(parts) < 2 or first is None or isinstance(first, TurnWords) or choice is None:
        return None  # before a first turn it begins anywhere
    allowed = allowed_lanes(actor, lanes, choice, copies)
    places, stages = first.places(0), [stage_of(part, 0) for part in parts[1:]]
    begins = tuple(place for place in places if place.lane in allowed)
    found = shortest_route(lanes, begins, stages) if begins else 1
    if isinstance(found, PlannedRoute):
        return None
    return _unreachable(actor, parts[found], places, stages, found, lanes)


def _no_way_from_there(
    actor: ScenarioActor, candidates: CandidateBatch, lanes: LaneGraph
) -> Diagnostic | None:
    """RL618 of copies that are placed by another, which decides where they begin."""
    where = placed(actor, candidates)
    copies = CopyBatch.every(candidates, where.x.shape[1])
    points = route_points(actor, copies, lanes)
    if points is None:
        return None
    places = start_places(actor, where, lanes, copies)
    for row in np.flatnonzero(where.present[0]).tolist():
        place, stages = places[row], points.stages(row)
        found = 0 if place is None else route_through(lanes, place, stages)
        if place is not None and not isinstance(found, PlannedRoute):
            return _unreachable(actor, points.parts[found - 1], (place,), stages, found, lanes)
    return None


def _place_of(actor: ScenarioActor, part: int) -> str:
    """The key of where a part of a way is written: `at`, or a point of the route."""
    if "at" not in actor.option_spans or actor.at_fraction:
        return f"route {part}"
    return "at" if part == 0 else f"route {part - 1}"


def _span_of(actor: ScenarioActor, part: int) -> Span | None:
    place = _place_of(actor, part)
    return actor.span_of(place if place in actor.option_spans else "route")


def _far(actor: ScenarioActor, point: NearPoints, part: int, lanes: LaneGraph) -> Diagnostic:
    x, y = point.point(0)
    every = np.concatenate([edge.curve.points for edge in lanes.edges.values()])
    (west, south), (east, north) = (  # never -0
        every.min(axis=0).round() + 0.0, every.max(axis=0).round() + 0.0,
    )  # fmt: skip
    away = point.distance(0)
    return diagnose(
        Code.FAR_FROM_LANES,
        _span_of(actor, part),
        x=f"{x:g}m",
        y=f"{y:g}m",
        distance=f"{away:.0f}m" if away >= 100.0 else f"{away:.3g}m",
        network=actor.on,
        name=actor.name,
        help=f"a point is at most {FARTHEST:g}m from a lane; the roads of `{actor.on}` lie between "
        f"({west:.0f}m, {south:.0f}m) and ({east:.0f}m, {north:.0f}m), x east, y north",
    )


def _unreachable(
    actor: ScenarioActor,
    goal: Part,
    begins: tuple[RoutePlace, ...],
    stages: list[Stage],
    failed: int,
    lanes: LaneGraph,
) -> Diagnostic:
    """RL618 of the stage `failed`, from 1, which `goal` stands for."""
    options = [f"`{name}`" for name in ("lane", "facing") if name in actor.options]
    if options and isinstance(shortest_route(lanes, begins, stages), PlannedRoute):
        help_ = f"without {' and '.join(options)} there is one"
    elif isinstance(goal, TurnWords):
        help_ = _other_turns(begins, stages[: failed - 1], lanes)
    else:
        help_ = _other_way((begins, *stages)[failed - 1], goal.places(0), str(actor.on), lanes)
    return diagnose(
        Code.NO_ROUTE,
        _span_of(actor, failed),
        goal=_written(goal, stages[: failed - 1]),
        network=actor.on,
        name=actor.name,
        help=help_,
    )


def _other_turns(begins: tuple[RoutePlace, ...], passed: list[Stage], lanes: LaneGraph) -> str:
    """What is possible instead of a turn."""
    ways = [
        f"`{word}`"
        for word, turn in TURNS.items()
        if isinstance(shortest_route(lanes, begins, [*passed, NextTurn(turn)]), PlannedRoute)
    ]
    return f"possible there: {', '.join(ways)}" if ways else "no junction lies ahead"


def _other_way(origin: Stage, goal: tuple[RoutePlace, ...], network: str, lanes: LaneGraph) -> str:
    """What to do where no way leads to places."""
    if isinstance(origin, NextTurn):
        return "see where the lanes lead to: `emit svg` draws them"
    if isinstance(shortest_route(lanes, goal, [origin]), PlannedRoute):
        return (
            "there is one only in the other direction, and a route does not turn around on a road: "
            "add a point through which it can return, or let vehicles turn around at junctions: "
            "`u_turns: true` in the network"
        )
    roads = sorted({lanes.lanes[place.lane].edge for place in origin})
    names = ", ".join(f"`{network}/{road}`" for road in roads)
    return f"see where the lanes of {names} lead to: `emit svg` draws them"


def _written(goal: Part, passed: list[Stage]) -> str:
    if isinstance(goal, NearPoints):
        x, y = goal.point(0)
        return f"({x:g}m, {y:g}m)"
    if isinstance(goal, TurnWords):
        which = "next" if passed else "first"
        return f"`{goal.word(0)}` at its {which} junction"
    return f"`{goal.call.kind.rpartition('.')[2]}(...)`"
