"""Routes by lanes and connections: shortest ones, and random ones."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from roadlang.geometry import RoadNetwork, network_of_polylines
from roadlang.geometry.junctions.plan import PlanOptions, plan_junctions
from roadlang.geometry.routes.lane_graph import LANE_CHANGE, LaneGraph, TravelLane, lane_graph
from roadlang.geometry.routes.legs import PlannedRoute, RoutePlace
from roadlang.geometry.routes.nearest_lanes import near_roads
from roadlang.geometry.routes.random_routes import random_route
from roadlang.geometry.routes.shortest import shortest_route
from tests.geometry.junctions.crossings_of_roads import sections_of, star


def graph_of(network: RoadNetwork, lanes: int = 2, one_way: tuple[int, ...] = ()) -> LaneGraph:
    sections = sections_of(network, lanes, one_way)
    return lane_graph(network.edges, sections, plan_junctions(network, sections))


def grid(side: int = 3, block: float = 80.0, width: float = 7.0) -> RoadNetwork:
    lines = []
    for i in range(side):
        for j in range(side):
            here = (i * block, j * block)
            if i + 1 < side:
                lines.append([here, ((i + 1) * block, j * block)])
            if j + 1 < side:
                lines.append([here, (i * block, (j + 1) * block)])
    return network_of_polylines(lines, width)


@cache
def grid_graph() -> LaneGraph:
    return graph_of(grid())


def through(graph: LaneGraph, *points: tuple[float, float]) -> PlannedRoute:
    near = near_roads(graph, np.array(points))
    stages = [near.options(graph, number, lambda _: True) for number in range(len(points))]
    found = shortest_route(graph, stages[0], stages[1:])
    assert isinstance(found, PlannedRoute)
    return found


def roads_of(graph: LaneGraph, route: PlannedRoute) -> list[int]:
    roads = [graph.lanes[leg.lane].edge for leg in route.legs]
    return [road for road, before in zip(roads, [None, *roads], strict=False) if road != before]


def assert_drivable(graph: LaneGraph, route: PlannedRoute) -> None:
    """Every leg runs as its lane does, and leads to the next by a turn or a change of lane."""
    for leg in route.legs:
        lane = graph.lanes[leg.lane]
        assert lane.lane in graph.sections[lane.edge].ids
        direction = graph.sections[lane.edge].lane(lane.lane).direction
        assert direction in ("both", "backward" if lane.backward else "forward")
        assert (leg.stop <= leg.start) if lane.backward else (leg.stop >= leg.start)
    for leg, after in pairwise(route.legs):
        if leg.turn is None:
            assert after.lane in graph.neighbors[leg.lane]
            assert after.start == leg.stop
        else:
            assert leg.turn in graph.turns[leg.lane]
            assert leg.stop == graph.end[leg.lane]
            assert leg.turn.target == after.lane
            assert after.start == graph.begin[after.lane]


def test_the_shortest_way_round_a_block() -> None:
    graph = grid_graph()
    route = through(graph, (20.0, -2.0), (160.0, 60.0))
    assert_drivable(graph, route)
    assert route.cost == pytest.approx(140.0 + 60.0, abs=15.0)


def test_a_route_passes_its_points_in_order() -> None:
    graph = grid_graph()
    there = through(graph, (20.0, 0.0), (160.0, 20.0))
    detour = through(graph, (20.0, 0.0), (40.0, 160.0), (160.0, 20.0))
    assert_drivable(graph, detour)
    assert detour.cost > there.cost + 100.0
    assert (
        roads_of(graph, through(graph, (40.0, 160.0), (160.0, 20.0)))[-1]
        == roads_of(graph, detour)[-1]
    )


def test_a_one_way_road_is_driven_in_its_direction_only() -> None:
    network = star(0.0, 120.0, 240.0)
    graph = graph_of(network, one_way=(1,))
    away, toward = (1, False), (1, True)
    ways = {(lane.edge, lane.backward) for lane in graph.lanes}
    assert away in ways
    assert toward not in ways
    near = near_roads(graph, np.array([[80.0, 0.0], [-40.0, 69.0]]))
    stages = [near.options(graph, number, lambda _: True) for number in range(2)]
    assert shortest_route(graph, stages[0], stages[1:]) == 1
    assert isinstance(shortest_route(graph, stages[1], stages[:1]), PlannedRoute)


def test_lanes_are_changed_where_the_turn_needs_another() -> None:
    graph = graph_of(star(0.0, 90.0, 180.0, 270.0, width=14.0), lanes=4)
    start = graph.lanes.index(TravelLane(2, 2, True))
    left = next(
        turn
        for lane in graph.carriageways[start]
        for turn in graph.turns[lane]
        if turn.turn == "left" and turn not in graph.turns[start]
    )
    goal = RoutePlace(left.target, graph.end[left.target])
    route = shortest_route(graph, [RoutePlace(start, 95.0)], [[goal]])
    assert isinstance(route, PlannedRoute)
    assert_drivable(graph, route)
    assert len([leg for leg in route.legs if leg.turn is None]) == 2


def test_no_lane_is_changed_where_there_is_no_room() -> None:
    graph = graph_of(star(0.0, 90.0, 180.0, 270.0, width=14.0), lanes=4)
    lane = graph.lanes.index(TravelLane(2, 2, True))
    assert {exit_.changes for exit_ in graph.exits(lane, LANE_CHANGE)} == {0, 1}
    assert {exit_.changes for exit_ in graph.exits(lane, LANE_CHANGE - 0.1)} == {0}


def test_solid_lines_are_not_crossed() -> None:
    network = star(0.0, 120.0, 240.0, width=14.0)
    sections = sections_of(network, 4)
    plan = plan_junctions(network, sections, PlanOptions())
    assert any(lane_graph(network.edges, sections, plan).neighbors)
    solid = {
        edge: replace(
            section, lanes=tuple(replace(lane, marking="solid") for lane in section.lanes)
        )
        for edge, section in sections.items()
    }
    assert not any(lane_graph(network.edges, solid, plan).neighbors)


def test_a_closed_road_without_junction_goes_on_over_its_seam() -> None:
    angles = np.linspace(0.0, 2.0 * math.pi, 60, endpoint=False)
    ring = [(50.0 * math.cos(a), 50.0 * math.sin(a)) for a in angles]
    graph = graph_of(network_of_polylines([[*ring, ring[0]]], 7.0))
    route = random_route(graph, RoutePlace(0, 30.0), 700.0, 0.3)
    lengths = sum(abs(leg.stop - leg.start) for leg in route.legs)
    assert lengths == pytest.approx(700.0)


numbers = st.floats(0.0, 1.0, exclude_max=True)


@given(
    angles=st.lists(st.integers(0, 35), min_size=3, max_size=5, unique=True),
    lanes=st.integers(1, 4),
    number=numbers,
    share=numbers,
)
@settings(max_examples=25, deadline=None)
def test_a_random_route_is_drivable(
    angles: list[int], lanes: int, number: float, share: float
) -> None:
    network = star(*(10.0 * angle for angle in sorted(angles)), width=3.5 * lanes)
    graph = graph_of(network, lanes)
    if not graph.lanes:
        return
    lane = int(share * len(graph.lanes))
    middle = (graph.begin[lane] + graph.end[lane]) / 2.0
    assert_drivable(graph, random_route(graph, RoutePlace(lane, middle), 300.0, number))


@given(number=numbers)
@settings(max_examples=30, deadline=None)
def test_close_numbers_begin_with_the_same_turns(number: float) -> None:
    graph = grid_graph()
    first = random_route(graph, RoutePlace(0, graph.begin[0]), 400.0, number)
    near = min(number + 1e-9, 1.0 - 1e-9)
    other = random_route(graph, RoutePlace(0, graph.begin[0]), 400.0, near)
    assert first.legs[0].turn == other.legs[0].turn


def test_all_turns_are_equally_likely() -> None:
    graph = graph_of(star(0.0, 90.0, 180.0, 270.0))
    inbound = graph.lanes.index(TravelLane(1, 1, True))
    start = RoutePlace(inbound, graph.begin[inbound])
    routes = [random_route(graph, start, 150.0, (k + 0.5) / 300) for k in range(300)]
    chosen = [route.legs[-1].lane for route in routes]
    counts = [chosen.count(lane) for lane in set(chosen)]
    assert counts == [100, 100, 100]


@given(
    x=st.floats(-5.0, 165.0), y=st.floats(-5.0, 165.0), u=st.floats(-5, 165), v=st.floats(-5, 165)
)
@settings(max_examples=40, deadline=None)
def test_every_two_points_of_a_grid_of_streets_are_joined(
    x: float, y: float, u: float, v: float
) -> None:
    graph = grid_graph()
    assert_drivable(graph, through(graph, (x, y), (u, v)))


def test_a_random_route_keeps_off_lanes_that_bend_more_than_its_vehicle_can() -> None:
    hairpin = [
        (0.0, 0.0),
        (60.0, 0.0),
        (66.0, 2.0),
        (69.0, 7.0),
        (66.0, 12.0),
        (60.0, 14.0),
        (0.0, 16.0),
    ]
    network = network_of_polylines(
        [hairpin, [(0.0, 0.0), (-80.0, 0.0)], [(0.0, 0.0), (80.0, -60.0)]], 7.0
    )
    graph = graph_of(network)
    sharpest = {lane.edge: graph.sharpest_bend(n) for n, lane in enumerate(graph.lanes)}
    assert sharpest[1] > 1 / 12
    assert max(sharpest[2], sharpest[3]) < 1e-6
    start = next(n for n, lane in enumerate(graph.lanes) if lane.edge == 2 and lane.backward)
    entered = []
    for limit in (math.inf, 1 / 12):
        routes = [
            random_route(graph, RoutePlace(start, graph.begin[start]), 200.0, (k + 0.5) / 20, limit)
            for k in range(20)
        ]
        entered.append({road for route in routes for road in roads_of(graph, route)})
    assert 1 in entered[0]
    assert 1 not in entered[1]
