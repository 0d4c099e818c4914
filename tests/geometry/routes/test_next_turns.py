"""Routes by turns at junctions; a roundabout is one junction, a joint of two roads none."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from roadlang.geometry import RoadNetwork, network_of_polylines
from roadlang.geometry.junctions.plan import plan_junctions
from roadlang.geometry.routes.lane_graph import LaneGraph, TravelLane, lane_graph
from roadlang.geometry.routes.legs import ONWARD, PlannedRoute, RoutePlace
from roadlang.geometry.routes.next_turns import NextTurn, ways_on
from roadlang.geometry.routes.shortest import shortest_route
from roadlang.geometry.routes.walking import straight_route
from tests.geometry.junctions.crossings_of_roads import sections_of, star
from tests.geometry.routes.test_routes import assert_drivable

WEST, SOUTH, EAST, NORTH = "west", "south", "east", "north"
ARM = 120.0
DIRECTIONS = {EAST: (1.0, 0.0), NORTH: (0.0, 1.0), WEST: (-1.0, 0.0), SOUTH: (0.0, -1.0)}


def graph_of(network: RoadNetwork, lanes: int = 2) -> LaneGraph:
    sections = sections_of(network, lanes)
    return lane_graph(network.edges, sections, plan_junctions(network, sections))


def crossing(*arms: str, lanes: int = 2) -> LaneGraph:
    angles = {EAST: 0.0, NORTH: 90.0, WEST: 180.0, SOUTH: 270.0}
    return graph_of(star(*(angles[arm] for arm in arms), width=3.5 * lanes), lanes)


def roundabout(*arms: str, radius: float = 25.0) -> LaneGraph:
    angles = sorted(math.atan2(DIRECTIONS[arm][1], DIRECTIONS[arm][0]) % math.tau for arm in arms)
    lines = []
    for begin, end in pairwise([*angles, angles[0] + math.tau]):
        around = np.linspace(begin, end, 24)
        lines.append(np.stack([np.cos(around), np.sin(around)], axis=-1) * radius)
    for angle in angles:
        out = np.array([math.cos(angle), math.sin(angle)])
        lines.append(np.stack([radius * out, ARM * out]))
    return graph_of(network_of_polylines([line.round(9).tolist() for line in lines], 7.0))


def toward(graph: LaneGraph, arm: str) -> RoutePlace:
    """Near the far end of an arm, in the direction of the junction."""
    number = min(range(len(graph.lanes)), key=lambda lane: _distance(graph, lane, arm, "begin"))
    return RoutePlace(number, graph.begin[number])


def arm_of(graph: LaneGraph, place: RoutePlace) -> str:
    """The arm along which traffic leaves the junction in the lane of a place."""
    return min(DIRECTIONS, key=lambda arm: _distance(graph, place.lane, arm, "end"))


def _distance(graph: LaneGraph, lane: int, arm: str, end: str) -> float:
    curve = graph.edges[graph.lanes[lane].edge].curve
    station = graph.begin[lane] if end == "begin" else graph.end[lane]
    x, y = curve.at(np.array([station]))[0]
    return math.hypot(x - ARM * DIRECTIONS[arm][0], y - ARM * DIRECTIONS[arm][1])


def turns_from(graph: LaneGraph, arm: str) -> dict[str, str]:
    return {way.turn: arm_of(graph, way.end) for way in ways_on(graph, toward(graph, arm))}


def test_the_ways_through_a_crossing() -> None:
    found = turns_from(crossing(EAST, NORTH, WEST, SOUTH), SOUTH)
    assert found == {"left": WEST, "straight": NORTH, "right": EAST}


def test_a_side_road_leads_left_and_right_only() -> None:
    assert turns_from(crossing(EAST, WEST, SOUTH), SOUTH) == {"left": WEST, "right": EAST}


@pytest.mark.parametrize(
    ("arms", "came", "ways"),
    [
        ((EAST, NORTH, WEST, SOUTH), SOUTH, {"left": WEST, "straight": NORTH, "right": EAST}),
        ((EAST, NORTH, WEST, SOUTH), EAST, {"left": SOUTH, "straight": WEST, "right": NORTH}),
        ((EAST, WEST, SOUTH), SOUTH, {"left": WEST, "right": EAST}),
        ((EAST, NORTH, SOUTH), SOUTH, {"straight": NORTH, "right": EAST}),
    ],
)
def test_a_roundabout_is_one_junction(
    arms: tuple[str, ...], came: str, ways: dict[str, str]
) -> None:
    graph = roundabout(*arms)
    assert graph.ring
    assert turns_from(graph, came) == {**ways, "u": came}


def test_a_joint_of_two_roads_is_no_junction() -> None:
    bent = network_of_polylines(
        [
            [(0.0, 0.0), (0.0, ARM)],
            [(0.0, ARM), (ARM, ARM)],
            [(ARM, ARM), (ARM, 2.0 * ARM)],
            [(ARM, ARM), (2.0 * ARM, ARM)],
        ],
        7.0,
    )
    graph = graph_of(bent)
    start = graph.lanes.index(TravelLane(1, -1, False))
    ways = ways_on(graph, RoutePlace(start, graph.begin[start]))
    assert {way.turn: graph.lanes[way.end.lane].edge for way in ways} == {"left": 3, "straight": 4}
    assert all([graph.lanes[leg.lane].edge for leg in way.legs] == [1, 2] for way in ways)


def test_lanes_are_changed_for_a_turn() -> None:
    graph = crossing(EAST, NORTH, WEST, SOUTH, lanes=4)
    here = toward(graph, SOUTH)
    outer = max(graph.carriageways[here.lane], key=lambda lane: abs(graph.lanes[lane].lane))
    route = shortest_route(graph, [RoutePlace(outer, here.station)], [NextTurn("left")])
    assert isinstance(route, PlannedRoute)
    first, turning = route.legs[:2]
    assert (first.lane, first.turn) == (outer, None)
    assert turning.turn is not None
    assert turning.turn.turn == "left"


def test_after_its_last_turn_a_route_goes_straight_on() -> None:
    lines = [[(0.0, 0.0), (0.0, 100.0)], [(0.0, 100.0), (0.0, 200.0)], [(0.0, 200.0), (0.0, 300.0)]]
    lines += [[(0.0, y), (x, y)] for y in (100.0, 200.0) for x in (-90.0, 90.0)]
    graph = graph_of(network_of_polylines(lines, 7.0))
    start = graph.lanes.index(TravelLane(1, -1, False))
    route = shortest_route(graph, [RoutePlace(start, graph.begin[start])], [NextTurn("straight")])
    assert isinstance(route, PlannedRoute)
    assert [graph.lanes[leg.lane].edge for leg in route.legs] == [1, 2, 3]
    assert sum(abs(leg.stop - leg.start) for leg in route.legs) < ONWARD
    assert route.legs[-1].stop == graph.end[route.legs[-1].lane]


@pytest.mark.parametrize(
    ("arms", "leaves_at"),
    [((WEST, EAST, NORTH), EAST), ((WEST, SOUTH, EAST, NORTH), EAST), ((WEST, NORTH), NORTH)],
)
def test_straight_on_leaves_a_roundabout(arms: tuple[str, ...], leaves_at: str) -> None:
    graph = roundabout(*arms)
    route = straight_route(graph, toward(graph, WEST), ONWARD)
    last = route.legs[-1]
    assert last.stop == graph.end[last.lane]
    assert arm_of(graph, RoutePlace(last.lane, last.stop)) == leaves_at
    assert_drivable(graph, route)


def test_straight_on_goes_round_a_ring_that_is_no_roundabout_once() -> None:
    graph = roundabout(EAST, NORTH, WEST, SOUTH, radius=65.0)
    assert not graph.ring
    route = shortest_route(graph, [toward(graph, SOUTH)], [NextTurn("right")])
    assert isinstance(route, PlannedRoute)
    lanes = [leg.lane for leg in route.legs]
    assert len(lanes) == len(set(lanes)) == 5, "its own arm and the four parts of the ring"
    assert route.legs[-1].turn is None
    assert route.legs[-1].stop == graph.end[lanes[-1]]


def test_turns_and_places_follow_each_other() -> None:
    graph = crossing(EAST, NORTH, WEST, SOUTH)
    here = toward(graph, SOUTH)
    (left,) = [way for way in ways_on(graph, here) if way.turn == "left"]
    beyond = RoutePlace(left.end.lane, graph.end[left.end.lane])
    by_both = shortest_route(graph, [here], [NextTurn("left"), [beyond]])
    by_place = shortest_route(graph, [here], [[beyond]])
    assert isinstance(by_both, PlannedRoute)
    assert isinstance(by_place, PlannedRoute)
    assert by_both.legs == by_place.legs
    assert by_both.cost == pytest.approx(by_place.cost)


def test_the_first_turn_that_is_not_there_is_named() -> None:
    graph = crossing(EAST, WEST, SOUTH)
    here = toward(graph, SOUTH)
    assert shortest_route(graph, [here], [NextTurn("straight")]) == 1
    assert shortest_route(graph, [here], [NextTurn("left"), NextTurn("left")]) == 2
