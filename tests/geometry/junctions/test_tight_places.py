"""Junctions with little room: bends, blocks, short roads and dead ends right behind them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import shapely

from benchmarks.junctions.checks import check_junction
from roadlang.geometry import Curve, Edge, Node, RoadNetwork, filleted, network_of_polylines
from roadlang.geometry.junctions.folds import folded_spans, past
from roadlang.geometry.junctions.overlaps import junction_overlaps
from roadlang.geometry.networks.junction_model import Arm, Junction, JunctionPlan
from tests.geometry.junctions.crossings_of_roads import only, plan_of, sections_of, star


def network_of_streets(*lines: Any, width: float, radius: float) -> RoadNetwork:
    """Streets with round corners, joined where they end at the same points."""
    curves = [filleted(np.array(line, dtype=float), radius) for line in lines]
    places: dict[tuple[float, float], int] = {}
    edges = []
    for id, (line, curve) in enumerate(zip(lines, curves, strict=True), 1):
        start, end = (places.setdefault(tuple(line[i]), len(places)) for i in (0, -1))
        edges.append(Edge(id, start, end, curve, np.array([width, width])))
    nodes = tuple(Node(id, place) for place, id in places.items())
    return RoadNetwork(nodes, tuple(edges))


def faults(plan: JunctionPlan, network: RoadNetwork, lanes: int = 2) -> list[dict[str, float]]:
    sections = sections_of(network, lanes)
    return [check_junction(j, plan, network, sections).faults for j in plan.junctions]


def test_no_road_begins_in_a_bend_that_its_inner_border_crosses() -> None:
    """Half a width of 8 m round a bend of 6 m: the borders before and after it overlap."""
    network = network_of_streets(
        [(0, 0), (-60, 0)], [(0, 0), (0, 60)], [(0, 0), (14, 0), (14, -60)], width=16, radius=6
    )
    plan = plan_of(network, lanes=4)
    bend = 14.0 - 6.0, 14.0 - 6.0 + 6.0 * np.pi / 2.0
    assert plan.trims[3][0] > bend[1] + 1.9 or plan.trims[3][0] < bend[0] - 1.9
    assert faults(plan, network, lanes=4) == [{}]


def test_a_bend_of_two_roads_has_no_notch_at_its_outside() -> None:
    network = network_of_polylines([[(0, 0), (-60, 0)], [(0, 0), (0, 60)]], 7.0)
    plan = plan_of(network)
    (joint,) = [junction for junction in plan.junctions if junction.kind == "joint"]
    area = shapely.Polygon(joint.area)
    assert area.covers(shapely.Point(1.7, -1.7))  # between the ends at (0, -3.5) and (3.5, 0)
    assert not area.covers(shapely.Point(2.0, -2.0))
    assert faults(plan, network) == [{}]


def test_a_turn_that_is_sharper_than_its_lane_is_wide_gets_narrower() -> None:
    """Lanes of 9 and 12 m: the inner border of a connection of that width would run backward."""
    network = star(0, 230, 170, length=150.0, width=[18.0, 7.0, 24.0])
    plan = plan_of(network)
    (junction,) = plan.junctions
    turned = [c.curvature * max(c.widths) / 2.0 for c in junction.connections]
    assert 0.9 < max(turned) < 1.0
    assert faults(plan, network) == [{}]


def test_a_border_that_crosses_itself_is_found_from_crossing_to_crossing() -> None:
    s = np.linspace(0.0, 40.0, 401)
    curve = filleted(np.array([(0.0, 0.0), (20.0, 0.0), (20.0, 60.0)]), 5.0)
    points, normal = curve.at(s), curve.normal(s)
    ((start, stop),) = folded_spans(s, points, (points + 8.0 * normal, points - 8.0 * normal))
    assert np.allclose([start, stop], [15 - 3, 15 + 5 * np.pi / 2 + 3], atol=0.2)
    assert past(((start, stop),), 11.0) == 11.0
    assert past(((start, stop),), 13.0) == stop


def test_a_curb_that_turns_about_a_point_is_no_fold() -> None:
    s = np.linspace(0.0, 40.0, 401)
    curve = filleted(np.array([(0.0, 0.0), (20.0, 0.0), (20.0, 60.0)]), 5.0)
    border = curve.at(s) + 5.0 * curve.normal(s)
    assert folded_spans(s, curve.at(s), (border, border)) == ()


def test_a_block_with_both_ends_at_one_place_keeps_its_road() -> None:
    """Two T mouths 12 m apart are one place; the road round the block is trimmed as any other."""
    network = network_of_streets(
        [(-60, 0), (0, 0)], [(0, 0), (12, 0)], [(12, 0), (70, 0)],
        [(0, 0), (0, -50), (12, -50), (12, 0)], width=6, radius=4,
    )  # fmt: skip
    plan = plan_of(network)
    assert only(plan).inside == (2,)
    assert max(plan.trims[4]) < 15.0


def test_wide_roads_get_rounder_curbs_only_where_that_leaves_room() -> None:
    """Curbs of 4 m need 24 m between two crossings of roads that are 16 m wide."""
    lines = [
        [(0, 0), (23, 0)], [(0, 0), (-60, 0)], [(0, 0), (0, 60)], [(0, 0), (0, -60)],
        [(23, 0), (80, 0)], [(23, 0), (23, 60)], [(23, 0), (23, -60)],
    ]  # fmt: skip
    plan = plan_of(network_of_polylines([np.array(line) for line in lines], 16.0), lanes=4)
    assert [junction.nodes for junction in plan.junctions] == [(0,), (1,)]
    assert not plan.problems


def test_a_turn_into_a_short_dead_end_may_use_nearly_all_of_it() -> None:
    lines = [[(0, 0), (8.45, 0)], [(0, 0), (0, -8.45)], [(0, 0), (-60, 0)], [(0, 0), (0, 60)]]
    plan = plan_of(network_of_polylines([np.array(line) for line in lines], 8.45), lanes=3)
    assert not only(plan).refused


def test_junctions_between_which_turns_have_no_room_are_one() -> None:
    """The bend of the short road leaves no room for the turns of the T mouth behind it."""
    network = network_of_streets(
        [(0, 0), (-60, 0)], [(0, 0), (8, 0)], [(8, 0), (8, 60)], [(8, 0), (16, 0), (16, -16)],
        [(16, -16), (60, -16)], [(0, 0), (0, -40), (16, -40), (16, -16)], width=7.7, radius=3.85,
    )  # fmt: skip
    plan = plan_of(network)
    assert not [p for p in plan.problems if p.kind in ("refused", "sweep", "stuck")]
    assert faults(plan, network) == [{}] * len(plan.junctions)


def test_a_ring_through_one_junction_still_turns_into_itself() -> None:
    ring = Curve.through(np.array([(0, 0), (30, -12), (40, 10), (20, 30), (0, 0)], dtype=float))
    line = Curve.through(np.array([(0.0, 0.0), (-80.0, -10.0)]))
    x, y = line.at(line.length)
    network = RoadNetwork(
        (Node(0, (0.0, 0.0)), Node(1, (float(x), float(y)))),
        (Edge(1, 0, 0, ring, np.full(2, 7.0)), Edge(2, 0, 1, line, np.full(2, 7.0))),
    )
    turns = {(c.source.end, c.target.end) for c in only(plan_of(network)).connections
             if c.source.edge == c.target.edge == 1}  # fmt: skip
    assert turns == {("start", "end"), ("end", "start")}


def test_the_corner_of_a_bent_road_is_measured_where_it_is_trimmed() -> None:
    """A road that leaves at a right angle and soon turns away, on a circle of 12 m."""
    angles = np.linspace(0.0, 2.0, 21)
    bent = np.column_stack([12.0 * np.sin(angles), 12.0 - 12.0 * np.cos(angles)])
    lines = [bent, bent * (-1.0, 1.0), np.array([(0.0, 0.0), (0.0, -60.0)])]
    network = network_of_polylines(lines, 12.0)
    plan = plan_of(network)
    assert plan.trims[3][0] > 6.0
    assert faults(plan, network) == [{}]


def test_two_roads_that_nobody_drives_through_do_not_overlap_at_their_joint() -> None:
    lines = [np.array([(0.0, 0.0), (60.0, 0.0)]), np.array([(0.0, 0.0), (-43.0, 43.0)])]
    network = network_of_polylines(lines, 11.0)
    plan = plan_of(network, one_way=[1, 2])
    assert not plan.problems
    half_angle = np.radians(45.0 / 2.0)
    assert plan.trims[1][0] >= 5.5 * np.tan(half_angle) - 1e-6


def test_a_narrow_block_at_one_junction_has_a_tighter_curb_in_its_corner() -> None:
    """Between the two ends of a road round a block, 6 m apart, there is no room for 2 x 4 m."""
    network = network_of_streets(
        [(0, 0), (-60, 0)], [(0, 0), (0, -60)],
        [(0, 0), (60, 0), (60, 20), (0, 20), (0, 0)], width=14, radius=9,
    )  # fmt: skip
    plan = plan_of(network, lanes=4)
    assert max(plan.trims[3]) < 20.0
    assert faults(plan, network, lanes=4) == [{}]


def test_trims_that_help_no_turn_are_not_moved() -> None:
    """No trim makes room for the turns between two roads side by side, 3 m apart."""
    lines = [
        np.array([(0.0, 0.0), (9.0, 0.0)]),
        np.array([(0.0, 0.0), (0.0, 100.0)]),
        np.array([(9.0, 0.0), (9.0, 100.0)]),
        np.array([(0.0, 0.0), (-60.0, 0.0)]),
    ]
    network = network_of_polylines(lines, 6.0)
    plan = plan_of(network)
    assert max(plan.trims[2][0], plan.trims[3][0]) < 15.0
    assert faults(plan, network) == [{}]


def square(id: int, x: float) -> Junction:
    area = ((x, 0.0), (x + 10.0, 0.0), (x + 10.0, 10.0), (x, 10.0))
    arms = (Arm(3, "start", 5.0, 0, 3), Arm(4 + id, "end", 5.0, 2, 1))
    return Junction(id, (id,), "junction", area, arms, (), (), ())


def test_two_junctions_that_overlap_are_reported_with_a_road_of_each() -> None:
    (problem,) = junction_overlaps([square(0, 0.0), square(1, 9.0), square(2, 30.0)])
    assert (problem.kind, problem.junction, set(problem.edges)) == ("overlap", 0, {3, 4})
    assert np.isclose(problem.amount, np.hypot(1.0, 10.0), atol=0.02)
    assert junction_overlaps([square(0, 0.0), square(1, 10.0)]) == ()


def test_a_junction_that_no_road_leads_to_overlaps_none() -> None:
    lonely = replace(square(1, 9.0), arms=())
    assert junction_overlaps([square(0, 0.0), lonely]) == ()
    assert junction_overlaps([lonely, square(2, 9.0)]) == ()
