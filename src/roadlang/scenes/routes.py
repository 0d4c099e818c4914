"""The routes of the agents of scenes."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..evaluate.indexed_scenario import IndexedScenario
from ..geometry.networks.junction_model import NO_JUNCTION
from ..geometry.routes.lane_graph import LaneGraph
from ..geometry.routes.legs import Leg, PlannedRoute
from ..ir.scenario import ScenarioActor, ScenarioNetwork
from ..ir.scene_actor import SceneActor
from ..ir.scene_route import RouteStep, RouteTurn, SceneRoute
from ..world.networks.lane_graphs import lanes_of_network
from ..world.placement.placement import placed_routes
from ..world.placement.routes import has_route
from ..world.placement.selected_routes import route_on_selected
from ..world.roads.road_places import from_root
from ..world.roads.selected_roads import has_lanes_of_network
from .scene_rows import SceneRows

_FIRST = np.zeros(2, np.intp)


def scene_routes(actor: ScenarioActor, rows: SceneRows) -> list[list[SceneRoute | None]]:
    """The route of each copy of an agent; nothing where none has one."""
    if not has_route(actor, rows.candidates):
        return rows.same([])
    return rows.each(partial(_routes_of_one, actor))


def _routes_of_one(actor: ScenarioActor, candidates: CandidateBatch) -> list[SceneRoute | None]:
    lanes = lanes_of_network(candidates.scenario.networks[str(actor.on)], candidates)
    found = placed_routes(actor, candidates)[0].tolist()
    return [
        None if route is None else _route(route, str(actor.on), lanes, candidates)
        for route in found
    ]


def may_be_on_network(actor: ScenarioActor, scenario: IndexedScenario) -> bool:
    """Whether `on_network` can change an agent."""
    road = scenario.roads.get(str(actor.on))
    if road is None or not actor.drive or not has_lanes_of_network(road, scenario):
        return False
    return any(isinstance(link, ScenarioNetwork) for link in scenario.ancestry(road))


def on_network(actor: ScenarioActor, placed: SceneActor, candidates: CandidateBatch) -> SceneActor:
    """An agent on a road that runs over a network, as one in the lanes of that network; others as
    they are."""
    if placed.start is None or not actor.drive:
        return placed
    backward = placed.facing == "back"
    found = route_on_selected(actor, placed.start, placed.lane or 0, backward, candidates)
    if found is None:
        return placed
    lanes = lanes_of_network(candidates.scenario.networks[found.network], candidates)
    route = _route(found.route, found.network, lanes, candidates)
    first = route.steps[0]
    against = lanes.lanes[found.route.legs[0].lane].backward
    turned = against != backward
    offset = None if placed.offset is None else -placed.offset if turned else placed.offset
    return replace(
        placed, road=first.road, start=first.start, lane=first.lane, offset=offset,
        facing="back" if against else "forward", route=route,
    )  # fmt: skip


def _route(
    route: PlannedRoute, network: str, lanes: LaneGraph, candidates: CandidateBatch
) -> SceneRoute:
    return SceneRoute(
        tuple(_step(leg, network, lanes, candidates) for leg in route.legs), route.closed
    )


def _step(leg: Leg, network: str, lanes: LaneGraph, candidates: CandidateBatch) -> RouteStep:
    """Its arc lengths are along the road of the scene, which may be bent."""
    lane, turn = lanes.lanes[leg.lane], None
    if leg.turn is not None and leg.turn.junction != NO_JUNCTION:
        turn = RouteTurn(network, leg.turn.junction, leg.turn.connection)
    name, ends = f"{network}/{lane.edge}", np.array([leg.start, leg.stop])
    start, stop = from_root(name, candidates, _FIRST, ends).tolist()
    return RouteStep(name, lane.lane, start, stop, turn)
