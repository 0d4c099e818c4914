"""Cross-sections, edges, joined roads, networks and lane graphs from random numbers, in lines."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from roadlang import geometry as g
from roadlang.geometry.curves.offsetting import offset
from roadlang.geometry.junctions.one_way import one_way
from roadlang.geometry.junctions.plan import plan_junctions
from roadlang.geometry.lanes.joining import RoadToJoin, joined_curve, joined_section
from roadlang.geometry.networks.paths import longest_path, nearest_place, shortest_path
from roadlang.geometry.routes.lane_graph import LaneGraph, lane_graph
from roadlang.geometry.routes.legs import RoutePlace
from roadlang.geometry.routes.nearest_lanes import near_roads
from roadlang.geometry.routes.random_routes import random_route
from roadlang.geometry.routes.shortest import shortest_route
from roadlang.geometry.routes.walking import following_legs, parts_ahead, parts_behind, walked
from roadlang.geometry.routes.walking import straight_route as straight
from tests.golden.geometry_views import plain_value
from tests.golden.summaries import array, of_json

_KINDS = ("drive", "drive", "drive", "bike", "parking", "sidewalk", "median")
_MARKINGS: tuple[Any, ...] = ("solid", "broken", "double", "none", "curb")


def _numbers(value: Any) -> str:
    return array(np.asarray(value, dtype=float).ravel().tolist())


def _side(rng: np.random.Generator, sign: int, length: float) -> list[g.Lane]:
    lanes = []
    for place in range(int(rng.integers(1, 5))):
        kind = str(rng.choice(_KINDS)) if place else "drive"
        drivable = kind == "drive"
        direction: Any = "none" if kind in ("parking", "median") else "backward"
        direction = "forward" if sign < 0 and direction == "backward" else direction
        stations = np.linspace(0.0, length, int(rng.integers(1, 4)))
        widths = rng.uniform(1.0, 4.0, len(stations))
        limit = float(rng.choice([8.0, 14.0])) if rng.random() < 0.4 else None
        marking = _MARKINGS[int(rng.integers(len(_MARKINGS)))]
        profile = g.WidthProfile(stations, widths)
        lanes.append(g.Lane(sign * (place + 1), kind, profile, direction, drivable, limit, marking))
    return lanes


def section(rng: np.random.Generator, length: float) -> g.CrossSection:
    """Random lanes on both sides of a line, some of which is not in the middle of them."""
    left, right = _side(rng, 1, length), _side(rng, -1, length)
    center = None
    if rng.random() < 0.5:
        stations = np.array([0.0, 0.6 * length])
        center = g.OffsetProfile(stations, rng.uniform(-2.0, 2.0, 2))
    marking = _MARKINGS[int(rng.integers(3))]
    return g.CrossSection((*left[::-1], *right), marking, center)


def section_lines(first: int, count: int) -> Iterator[str]:
    """Cross-sections: lanes, borders, widths; reversed, mirrored, scaled, stretched, one-way."""
    for number in range(first, first + count):
        rng = np.random.default_rng(number)
        length = float(rng.uniform(30.0, 90.0))
        made = section(rng, length)
        s = np.linspace(0.0, length, 9)
        yield f"{number}: {made.ids} {made.markings} {made.lane_count} {made.driving_ids()}"
        variants = {
            "as it is": made,
            "reversed": made.reversed(length),
            "mirrored": made.mirrored(),
            "scaled": made.scaled(1.5, 0.8),
            "stretched": made.scaled_to(g.WidthProfile(s, made.drivable_width(s) * 1.1 + 0.1)),
            "one way": one_way(made, number % 2 == 0),
        }
        for name, one in variants.items():
            borders = [_numbers(part) for lane in one.ids for part in one.borders(lane, s)]
            yield f"  {name}: {one.ids} {one.center_marking} {one.markings} {borders[0]}"
            yield f"    {_numbers(one.border_offsets(s))} {_numbers(one.width(s))}"
            yield f"    {_numbers(one.half_widths(s))} {_numbers(one.drivable_extent(s))}"
            yield f"    {_numbers([one.offset(lane, s) for lane in one.ids])}"
            yield f"    {_numbers([one.lane_width(lane, s) for lane in one.ids])}"
            ways = [
                (lane.direction, lane.kind, lane.speed_limit, lane.drivable) for lane in one.lanes
            ]
            yield f"    {ways} {one.driving_ids('forward')} {one.driving_ids('backward')}"
            yield f"    {_numbers(one.lane_at(np.linspace(-9.0, 9.0, 9), s))}"
            yield f"    {_numbers(one.drivable_profile().at(s))}"


def bends(rng: np.random.Generator) -> g.Curve:
    pieces: list[Any] = [g.Straight(float(rng.uniform(5.0, 30.0)))]
    for _ in range(int(rng.integers(1, 4))):
        turn = float(rng.uniform(0.2, 1.4) * rng.choice([-1.0, 1.0]))
        pieces.append(g.Arc(float(rng.uniform(6.0, 40.0)), turn))
        pieces.append(
            g.Clothoid(float(rng.uniform(5.0, 20.0)), 0.0, float(rng.uniform(-0.05, 0.05)))
        )
    start = tuple(rng.uniform(-50.0, 50.0, 2).tolist())
    return g.chain(pieces, start, float(rng.uniform(-3.0, 3.0))).curve()


def joined_lines(first: int, count: int) -> Iterator[str]:
    """Roads joined end to end, and lines beside them."""
    for number in range(first, first + count):
        rng = np.random.default_rng(number)
        curves = [bends(rng) for _ in range(2 + number % 2)]
        parts = [RoadToJoin(curve, section(rng, curve.length)) for curve in curves]
        joined = joined_curve(curves)
        at = np.linspace(0.0, joined.length, 40)
        yield f"{number}: {joined.length:.10g} {_numbers(joined.at(at))}"
        yield f"  {_numbers(joined.heading(at))} {_numbers(joined.curvature(at))}"
        made = joined_section(parts, float(rng.uniform(3.0, 40.0)))
        yield from of_json(plain_value(made), "  ")
        yield f"  borders {_numbers(made.border_offsets(at))}"
        for away in (2.0, -7.0, 0.3 * at - 4.0):
            yield f"  beside {_numbers(offset(joined, away, at))}"
        ring = g.Curve.through(np.stack([20 * np.cos(at / 8), 12 * np.sin(at / 8)], 1)[:6], True)
        places = np.linspace(0.0, ring.length, 30, endpoint=False)
        yield f"  ring {_numbers(offset(ring, 6.0, places))} {_numbers(offset(ring, -9.0, places))}"
        part = ring.between(0.8 * ring.length, 0.3 * ring.length)
        yield f"  part {part.length:.10g} {_numbers(part.at([0.0, 5.0]))}"
        yield f"  evenly {_numbers(ring.resampled(count=12).at(places))}"


def _network(rng: np.random.Generator) -> g.RoadNetwork:
    """Three by three streets, bent, some of them left out, and a road of its own."""
    nodes = {
        (i, j): rng.uniform(-9.0, 9.0, 2) + np.array([60.0 * i, 55.0 * j])
        for i in range(3)
        for j in range(3)
    }
    lines = []
    for (i, j), here in nodes.items():
        for other in ((i + 1, j), (i, j + 1)):
            if other in nodes and rng.random() < 0.85:
                there = nodes[other]
                middle = 0.5 * (here + there) + rng.uniform(-6.0, 6.0, 2)
                lines.append([here.tolist(), middle.tolist(), there.tolist()])
    lines.append([[-80.0, -40.0], [-60.0, 10.0], [-85.0, 50.0]])
    return g.network_of_polylines(lines, 7.0)


def network_lines(first: int, count: int) -> Iterator[str]:
    """Networks: parts, paths, transformed ones; their lanes, and routes along those."""
    for number in range(first, first + count):
        rng = np.random.default_rng(number)
        network = _network(rng)
        yield f"{number}: {network.length:.10g} {network.bounds} {network.components}"
        yield f"  degrees {[network.degree(node.id) for node in network.nodes]}"
        moved = network.transformed([[0.0, 2.0], [2.0, 0.0]], (5.0, 7.0), 1.5).scaled(0.5)
        yield f"  moved {moved.bounds} {_numbers([edge.width.at(9.0) for edge in moved.edges])}"
        yield from _path(network.edge, 99)
        yield from _path(network.node, 99)
        points = rng.uniform(-20.0, 140.0, (6, 2))
        for p, q in zip(points[:3], points[3:], strict=True):
            edge, s = nearest_place(network, p)
            yield f"  nearest {edge.id} {s:.9g}"
            yield from _path(shortest_path, network, p, q)
        yield from _path(longest_path, network)
        counts = [int(n) for n in rng.integers(2, 5, len(network.edges))]
        sections = {
            edge.id: g.CrossSection.of_lane_count(lanes, edge.width, oneway=rng.random() < 0.2)
            for edge, lanes in zip(network.edges, counts, strict=True)
        }
        graph = lane_graph(network.edges, sections, plan_junctions(network, sections))
        yield from _graph(graph, points, rng)


def _path(find: Callable[..., Any], *arguments: Any) -> Iterator[str]:
    try:
        path = find(*arguments)
    except g.GeometryError as error:
        yield f"  {find.__name__}: {error}"
        return
    at = np.linspace(0.0, path.curve.length, 20)
    steps = [(step.edge, round(step.start, 7), round(step.stop, 7)) for step in path.steps]
    yield f"  {find.__name__}: {steps} {path.length:.10g} {_numbers(path.curve.at(at))}"
    yield f"    {_numbers(path.width.at(at))}"


def _graph(graph: LaneGraph, points: Any, rng: np.random.Generator) -> Iterator[str]:
    for number, lane in enumerate(graph.lanes):
        ends = f"{graph.begin[number]:.9g}..{graph.end[number]:.9g}"
        turns = [(turn.target, turn.turn, round(turn.length, 6)) for turn in graph.turns[number]]
        yield f"  {lane.edge} {lane.lane} {lane.backward} {ends} {graph.neighbors[number]} {turns}"
    near = near_roads(graph, points)
    stages = [near.options(graph, number, lambda _: True) for number in range(len(points))]
    yield f"  near {_numbers(near.distance)}"
    for origin, via, goal in zip(stages, stages[1:], stages[2:], strict=False):
        for wanted in ((origin, goal), (origin, via, goal)):
            found = shortest_route(graph, wanted[0], wanted[1:])
            yield f"  route {_route(found)}"
    for lane in rng.choice(len(graph.lanes), 5, replace=False).tolist():
        share = float(rng.uniform(0.2, 0.8))
        station = graph.begin[lane] + share * (graph.end[lane] - graph.begin[lane])
        place = RoutePlace(lane, float(station))
        ahead = straight(graph, place, 90.0)
        yield f"  straight {_route(ahead)} then {len(following_legs(graph, place, ahead))}"
        yield f"  wanders {_route(random_route(graph, place, 900.0, rng.random()))}"
        for parts in (parts_ahead(graph, place, ahead), parts_behind(graph, place)):
            yield f"  walked {walked(parts, (4.0, 45.0, 70.0), 2.0, _measured)}"


def _measured(lane: int, start: float, stop: float) -> float:
    return abs(stop - start)


def _route(route: Any) -> str:
    if isinstance(route, int):
        return f"none to {route}"
    legs = [(leg.lane, round(leg.start, 6), round(leg.stop, 6)) for leg in route.legs]
    return f"{route.cost:.9g} {legs}"
