"""The routes of agents on roads that run over a network: along the lanes of its roads."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby

import numpy as np

from ...evaluate.candidates import CandidateBatch
from ...geometry import Step
from ...geometry.routes.lane_graph import LaneGraph, TravelLane
from ...geometry.routes.legs import PlannedRoute, RoutePlace
from ...geometry.routes.shortest import shortest_route
from ...ir.scenario import ScenarioActor
from ..networks.lane_graphs import lanes_of_network
from ..roads.road_places import to_root
from ..roads.road_root import RoadRoot
from ..roads.roads import road_root
from ..roads.selected_roads import has_lanes_of_network, steps_in_network

_INSIDE = 1e-6
_ROUNDED = 10.0
"""Meters by which rounded corners shorten a road, at most"""


@dataclass(frozen=True, eq=False)
class SelectedRoute:
    """A route, and the network whose roads it leads along."""

    network: str
    route: PlannedRoute


def route_on_selected(
    actor: ScenarioActor, start: float, lane: int, backward: bool, candidates: CandidateBatch
) -> SelectedRoute | None:
    """The way of an agent of a single candidate to the end of its road, by the lanes of the network
    that the road was selected from. `start` is arc length along the road.

    None on other roads, on one that has lanes of its own, in no lane, in a junction, and where the
    junctions have no connection for it: the agent then follows the road itself.
    """
    road = candidates.scenario.roads.get(str(actor.on))
    if road is None or lane == 0 or not has_lanes_of_network(road, candidates.scenario):
        return None
    found = steps_in_network(road, candidates)
    if found is None:
        return None
    network, steps = found
    lanes = lanes_of_network(network, candidates)
    if len(steps) == 1 and lanes.edges[steps[0].edge].curve.closed:
        return None
    path = _path(road.name, steps, start, lane, backward, candidates, lanes)
    if path is None:
        return None
    route = shortest_route(lanes, path[0], path[1:])
    if not isinstance(route, PlannedRoute) or not _keeps_to(path, route, lanes):
        return None
    return SelectedRoute(network.name, route)


def _path(
    name: str,
    steps: tuple[Step, ...],
    start: float,
    lane: int,
    backward: bool,
    candidates: CandidateBatch,
    lanes: LaneGraph,
) -> list[list[RoutePlace]] | None:
    """The places that the route passes: where it begins, and the end of each road."""
    root = road_root(name, candidates)
    assert root.path is not None
    at = float(to_root(name, candidates, np.zeros(1, np.intp), np.array([start]))[0])
    traveled = at * root.path.length / root.frame.curve.length
    ends = np.cumsum([step.length for step in steps])
    first = min(int(np.searchsorted(ends, traveled, side="right")), len(steps) - 1)
    into = traveled - (ends[first] - steps[first].length)
    steps_back = [Step(step.edge, step.stop, step.start) for step in steps[: first + 1][::-1]]
    steps_back = steps_back if backward else list(steps[first:])
    against = steps[first].stop < steps[first].start
    station = _station(steps[first].start + (-into if against else into), steps[first], at, root)
    start_lane = TravelLane(steps[first].edge, -lane if against else lane, against != backward)
    if start_lane not in lanes.lanes:
        return None
    number = lanes.lanes.index(start_lane)
    low, high = sorted((lanes.begin[number], lanes.end[number]))
    if not low - _INSIDE <= station <= high + _INSIDE:
        return None
    places = [[RoutePlace(number, station)]]
    for step in steps_back:
        at_end = _at_end(step, lanes)
        if at_end:
            places.append(at_end)
    return places


def _station(near: float, step: Step, at: float, root: RoadRoot) -> float:
    """Arc length along the road of a step of the point at arc length `at`; `near` it, as corners
    are rounded."""
    assert root.path is not None
    curve = root.path.network.edge(step.edge).curve
    found = float(curve.project(root.frame.curve.at(np.array([at])))[0][0])
    return found if abs(found - near) < _ROUNDED else near


def _at_end(step: Step, lanes: LaneGraph) -> list[RoutePlace]:
    """In all lanes of a road that run the way of a step, as far along as it leads."""
    found = []
    for lane in lanes.of_edge.get(step.edge, ()):
        if lanes.forward(lane) != (step.stop > step.start):
            continue
        low, high = sorted((lanes.begin[lane], lanes.end[lane]))
        found.append(RoutePlace(lane, min(max(step.stop, low), high)))
    return found


def _keeps_to(path: list[list[RoutePlace]], route: PlannedRoute, lanes: LaneGraph) -> bool:
    """Whether a route leads along these roads, and no others between."""
    wanted = [lanes.lanes[stage[0].lane].edge for stage in path]
    driven = [lanes.lanes[leg.lane].edge for leg in route.legs]
    return [edge for edge, _ in groupby(wanted)] == [edge for edge, _ in groupby(driven)]
