"""What is wrong with a place or route in a network that no draw has a say in."""

from __future__ import annotations

import numpy as np

from ..diagnostics import Code, Diagnostic, Span, diagnose
from ..evaluate.candidates import CandidateBatch
from ..evaluate.copies import CopyBatch
from ..geometry.routes.lane_graph import LaneGraph
from ..geometry.routes.shortest import PlannedRoute, RoutePlace, shortest_route
from ..ir.scenario import ScenarioActor
from .lane_choices import allowed_lanes, lane_choices
from .lane_graphs import lanes_of_network
from .placement import placed
from .positions import names_another
from .road_poses import WrittenPlace
from .route_points import FARTHEST, NamedPlaces, NearPoints, route_parts, route_points
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
        parts = () if points is None else points.parts
    else:
        parts = route_parts(actor, copies, lanes)
    for part in parts:
        if isinstance(part, NearPoints) and part.distance(0) > FARTHEST:
            return _far(actor, part.point(0), part.distance(0), parts.index(part) + by_another)
    if by_another:
        return _no_way_from_there(actor, candidates, lanes)
    choice = lane_choices(actor, copies, WrittenPlace.of(actor, copies))[0]
    if len(parts) == 1 or choice is None:
        return None
    allowed = allowed_lanes(actor, lanes, choice, copies)
    stages = [part.places(0) for part in parts]
    begins = tuple(place for place in stages[0] if place.lane in allowed)
    found = shortest_route(lanes, [begins, *stages[1:]]) if begins else 1
    if isinstance(found, PlannedRoute):
        return None
    return _unreachable(actor, parts[found], stages, found, lanes)


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
            return _unreachable(actor, points.parts[found - 1], [(place,), *stages], found, lanes)
    return None


def _place_of(actor: ScenarioActor, part: int) -> str:
    """The key of where a part of a way is written: `at`, or a point of the route."""
    if "at" not in actor.option_spans:
        return f"route {part}"
    return "at" if part == 0 else f"route {part - 1}"


def _span_of(actor: ScenarioActor, part: int) -> Span | None:
    place = _place_of(actor, part)
    return actor.span_of(place if place in actor.option_spans else "route")


def _far(
    actor: ScenarioActor, point: tuple[float, float], distance: float, part: int
) -> Diagnostic:
    return diagnose(
        Code.FAR_FROM_LANES,
        _span_of(actor, part),
        x=f"{point[0]:g}m",
        y=f"{point[1]:g}m",
        distance=f"{distance:.3g}m",
        network=actor.on,
        name=actor.name,
        help=f"a point is at most {FARTHEST:g}m from a lane; x counts east, y north, from the "
        "lower left corner of a picture",
    )


def _unreachable(
    actor: ScenarioActor,
    goal: NearPoints | NamedPlaces,
    stages: list[tuple[RoutePlace, ...]],
    failed: int,
    lanes: LaneGraph,
) -> Diagnostic:
    options = [f"`{name}`" for name in ("lane", "facing") if name in actor.options]
    leg = stages[failed - 1 : failed + 1]
    if options and isinstance(shortest_route(lanes, stages), PlannedRoute):
        help_ = f"without {' and '.join(options)} there is one"
    elif isinstance(shortest_route(lanes, leg[::-1]), PlannedRoute):
        help_ = (
            "there is one only in the other direction, and a route does not turn around on a road: "
            "add a point through which it can return, or let vehicles turn around at junctions: "
            "`u_turns: true` in the network"
        )
    else:
        roads = sorted({lanes.lanes[place.lane].edge for place in leg[0]})
        names = ", ".join(f"`{actor.on}/{road}`" for road in roads)
        help_ = f"see where the lanes of {names} lead to: `emit svg` draws them"
    return diagnose(
        Code.NO_ROUTE,
        _span_of(actor, failed),
        goal=_written(goal),
        network=actor.on,
        name=actor.name,
        help=help_,
    )


def _written(goal: NearPoints | NamedPlaces) -> str:
    if isinstance(goal, NearPoints):
        x, y = goal.point(0)
        return f"({x:g}m, {y:g}m)"
    return f"`{goal.call.kind.rpartition('.')[2]}(...)`"
