"""Plans of small networks: trims, areas, connections, merging, roundabouts, dead ends."""

from __future__ import annotations

import math

import numpy as np
import pytest

from benchmarks.junctions.checks import check_junction, connection_points, effective_sections
from benchmarks.junctions.random_networks import KINDS, random_network
from roadlang.geometry import network_of_polylines
from roadlang.geometry.junctions.one_way import one_way as one_way_section
from roadlang.geometry.junctions.plan import PlanOptions, plan_junctions
from roadlang.geometry.networks.junction_model import Connection, JunctionPlan
from tests.geometry.junctions.crossings_of_roads import only, plan_of, sections_of, star


def turns_from(plan: JunctionPlan, edge: int) -> dict[int, str]:
    return {c.target.edge: c.turn for c in only(plan).connections if c.source.edge == edge}


def test_straight_roads_are_trimmed_where_a_curb_of_4_m_touches_them() -> None:
    """t = ((h + r) + (h + r) cos theta) / sin theta, with h = 3.5 m."""
    plan = plan_of(star(0, 80, 180, 260))
    at_corner = 7.5 * (1 + math.cos(math.radians(80))) / math.sin(math.radians(80))
    assert [trim[0] for trim in plan.trims.values()] == pytest.approx([at_corner] * 4, abs=1e-3)


def test_a_crossing_of_four_roads_has_every_turn() -> None:
    plan = plan_of(star(0, 90, 180, 270))
    assert len(only(plan).connections) == 12
    assert turns_from(plan, 1) == {2: "right", 3: "straight", 4: "left"}
    assert not plan.problems
    assert not only(plan).refused


def test_a_right_turn_keeps_a_lane_width_from_the_curb() -> None:
    """The curb has 4 m, the middle of a lane of 3.5 m is 1.75 m off it."""
    turns = [c for c in only(plan_of(star(0, 90, 180, 270))).connections if c.turn == "right"]
    assert [1 / c.curvature for c in turns] == pytest.approx([5.75] * 4)


def test_connections_start_and_end_on_their_lanes() -> None:
    plan = plan_of(star(0, 70, 190, 290), lanes=[2, 4, 2, 3])
    network = star(0, 70, 190, 290)
    sections = sections_of(network, [2, 4, 2, 3])
    for connection in only(plan).connections:
        points, headings = connection_points(connection)
        lane = connection.target
        s = plan.trims[lane.edge][0]
        curve = network.edge(lane.edge).curve
        wanted = curve.at(s) + sections[lane.edge].offset(lane.lane, s) * curve.normal(s)
        assert points[-1] == pytest.approx(wanted, abs=1e-9)
        assert math.cos(headings[-1] - float(curve.heading(s))) == pytest.approx(1.0)


def test_nobody_turns_into_a_one_way_road_against_it() -> None:
    plan = plan_of(star(0, 90, 180), one_way=[2])
    targets = {c.target.edge for c in only(plan).connections if c.source.edge == 1}
    assert targets == {2, 3}
    assert not any(c.source.edge == 2 for c in only(plan).connections)


def test_close_junctions_are_one_place_and_keep_the_road_between() -> None:
    network = network_of_polylines(
        [[(0, 0), (10, 0)], [(0, 0), (-90, 0)], [(0, 0), (0, 90)], [(10, 0), (100, 0)],
         [(10, 0), (10, -90)]]
    )  # fmt: skip
    junction = only(plan_of(network))
    assert junction.nodes == (0, 1)
    assert junction.inside == (1,)
    assert len(junction.arms) == 4


def test_junctions_with_room_between_them_stay_two() -> None:
    network = network_of_polylines(
        [[(0, 0), (40, 0)], [(0, 0), (-90, 0)], [(0, 0), (0, 90)], [(40, 0), (130, 0)],
         [(40, 0), (40, -90)]]
    )  # fmt: skip
    plan = plan_of(network)
    assert len(plan.junctions) == 2
    start, end = plan.trims[1]
    assert 40 - start - end > 2


def test_a_dead_end_inside_a_junction_is_reported() -> None:
    network = network_of_polylines(
        [[(0, 0), (90, 0)], [(0, 0), (-90, 0)], [(0, 0), (0, 90)], [(0, 0), (0, -4)]]
    )
    plan = plan_of(network)
    assert [(p.kind, p.edges) for p in plan.problems] == [("vanished", (4,))]
    assert only(plan).inside == (4,)


@pytest.mark.parametrize("end", [[(200, 0), (200, -4)], [(200, -4), (200, 0)]])
def test_a_dead_end_that_vanishes_names_the_junction_that_it_lies_in(
    end: list[tuple[float, float]],
) -> None:
    first = [[(0, 0), (-90, 0)], [(0, 0), (0, 90)], [(0, 0), (200, 0)]]
    network = network_of_polylines([*first, [(200, 0), (290, 0)], [(200, 0), (200, 90)], end])
    plan = plan_of(network)
    (problem,) = [p for p in plan.problems if p.kind == "vanished"]
    (junction,) = [found for found in plan.junctions if found.inside == (6,)]
    assert (problem.junction, problem.edges) == (junction.id, (6,))
    assert problem.amount == pytest.approx(4.0)
    assert len(plan.junctions) == 2


def test_a_short_dead_end_gets_tighter_corners_before_it_vanishes() -> None:
    network = network_of_polylines(
        [[(0, 0), (90, 0)], [(0, 0), (-90, 0)], [(0, 0), (0, 90)], [(0, 0), (0, -8)]]
    )
    plan = plan_of(network)
    assert not [p for p in plan.problems if p.kind == "vanished"]
    assert plan.trims[4][0] <= 6.0


def test_a_ring_is_a_roundabout_and_who_enters_yields() -> None:
    drawn = random_network("roundabout", 5)
    plan = plan_junctions(drawn.network, drawn.sections)
    assert {junction.kind for junction in plan.junctions} == {"roundabout"}
    sections = effective_sections(plan, drawn.sections)
    assert all(sections[edge].driving_ids("backward") == () for edge in plan.ring)
    for junction in plan.junctions:
        sources = {c.id: c.source.edge for c in junction.connections}
        for entering, circling in junction.yields:
            assert sources[entering] not in plan.ring
            assert sources[circling] in plan.ring


@pytest.mark.parametrize(("longer", "is_ring"), [(1.0, True), (1.3, True), (1.7, False)])
def test_a_ring_may_be_a_little_longer_than_wide(longer: float, is_ring: bool) -> None:
    around = np.linspace(0.0, math.tau, 61).round(9)
    line = np.stack([20.0 * longer * np.cos(around), 20.0 * np.sin(around)], axis=-1).round(9)
    halves = [line[:31].tolist(), [*line[30:60].tolist(), line[0].tolist()]]
    arms = [[line[0].tolist(), (120.0, 0.0)], [line[30].tolist(), (-120.0, 0.0)]]
    assert bool(plan_of(network_of_polylines([*halves, *arms])).ring) == is_ring


@pytest.mark.parametrize(
    ("radius", "one_way", "halves", "is_ring"),
    [
        (55.0, "forward", (), True), (70.0, "forward", (), False),
        (70.0, "forward", (1,), False), (70.0, "forward", (1, 2), True),
        (70.0, "backward", (1, 2), False), (140.0, "forward", (1, 2), True),
        (170.0, "forward", (1, 2), False),
    ],
)  # fmt: skip
def test_only_a_ring_that_is_one_way_all_around_may_be_great(
    radius: float, one_way: str, halves: tuple[int, ...], is_ring: bool
) -> None:
    """Counter-clockwise, as traffic on the right goes round."""
    around = np.linspace(0.0, math.tau, 121).round(9)
    line = (radius * np.stack([np.cos(around), np.sin(around)], axis=-1)).round(9)
    around_it = [line[:61].tolist(), [*line[60:120].tolist(), line[0].tolist()]]
    arms = [[line[0].tolist(), (300.0, 0.0)], [line[60].tolist(), (-300.0, 0.0)]]
    network = network_of_polylines([*around_it, *arms])
    sections = dict(sections_of(network))
    sections |= {id: one_way_section(sections[id], one_way == "forward") for id in halves}
    assert bool(plan_junctions(network, sections).ring) == is_ring


def test_a_square_block_is_no_roundabout() -> None:
    corners = [(0, 0), (30, 0), (30, 30), (0, 30)]
    lines = [[corners[i], corners[(i + 1) % 4]] for i in range(4)]
    lines += [[c, (5 * c[0] - 60, 5 * c[1] - 60)] for c in corners]
    assert not plan_of(network_of_polylines(lines)).ring


def test_a_joint_of_two_roads_is_connected_too() -> None:
    junction = only(plan_of(star(0, 150), lanes=[2, 4]))
    assert junction.kind == "joint"
    assert {(c.source.edge, c.target.edge) for c in junction.connections} == {(1, 2), (2, 1)}


def test_left_hand_traffic_is_the_mirror_image() -> None:
    network = star(0, 70, 190, 290)
    plan = plan_of(network, [2, 4, 2, 3])
    flipped = network.transformed(np.diag([1.0, -1.0]))
    sections = {id: s.mirrored() for id, s in sections_of(network, [2, 4, 2, 3]).items()}
    left = plan_junctions(flipped, sections, PlanOptions(left_hand=True))
    assert left.trims == plan.trims
    area = {(round(x, 9), round(-y, 9)) for x, y in only(left).area}
    assert area == {(round(x, 9), round(y, 9)) for x, y in only(plan).area}
    turned: dict[str, str] = {"left": "right", "right": "left", "straight": "straight"}
    assert [turned[c.turn] for c in only(left).connections] == [
        c.turn for c in only(plan).connections
    ]
    for image, seen in zip(only(left).connections, only(plan).connections, strict=True):
        x, y, heading = seen.start
        assert image.start == pytest.approx((x, -y, -heading))
        assert image.pieces == tuple((length, -bend) for length, bend in seen.pieces)
        assert (image.source.lane, image.target.lane) == (-seen.source.lane, -seen.target.lane)
        (left_x, left_y), (right_x, right_y) = seen.stop_line
        assert image.stop_line == ((right_x, -right_y), (left_x, -left_y))
        assert image.widths == seen.widths
    for arm, other in zip(reversed(only(left).arms), only(plan).arms, strict=True):
        x, y = only(left).area[arm.left]
        assert (x, -y) == pytest.approx(only(plan).area[other.right])


def test_a_plan_does_not_depend_on_the_order_of_the_roads() -> None:
    drawn = random_network("grid", 3)
    shuffled = type(drawn.network)(drawn.network.nodes[::-1], drawn.network.edges[::-1])
    assert plan_junctions(shuffled, drawn.sections) == plan_junctions(drawn.network, drawn.sections)


def turning(connection: Connection) -> float:
    return abs(sum(length * curvature for length, curvature in connection.pieces))


@pytest.mark.parametrize("kind", [kind for kind in KINDS if "junctions" not in kind])
def test_random_networks_have_no_gap_and_no_overlap(kind: str) -> None:
    """Drawings whose roads do not overlap beyond all trims; `benchmarks/junctions` counts all."""
    for seed in (11, 12):
        drawn = random_network(kind, seed)
        plan = plan_junctions(drawn.network, drawn.sections)
        sections = effective_sections(plan, drawn.sections)
        for junction in plan.junctions:
            assert check_junction(junction, plan, drawn.network, sections).faults == {}
            assert all(turning(c) <= 4.4 for c in junction.connections)


@pytest.mark.parametrize("kind", ["two junctions", "three junctions", "loop"])
def test_what_cannot_be_built_is_reported(kind: str) -> None:
    for seed in range(4):
        drawn = random_network(kind, seed)
        plan = plan_junctions(drawn.network, drawn.sections)
        reported = {problem.junction for problem in plan.problems}
        sections = effective_sections(plan, drawn.sections)
        for junction in plan.junctions:
            report = check_junction(junction, plan, drawn.network, sections)
            assert not report.faults or junction.id in reported
