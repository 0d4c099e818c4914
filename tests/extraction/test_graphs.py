"""What is done to the graph of a skeleton, on graphs drawn by hand."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang_standard.extraction.graphs.chains import chains, direction, heading
from roadlang_standard.extraction.graphs.dead_ends import dead_ends
from roadlang_standard.extraction.graphs.graph import Graph, Line
from roadlang_standard.extraction.graphs.graph_cleanup import (
    at_border,
    components,
    contract,
    drop_crumbs,
    drop_loops,
    extend_to_border,
    join,
    prune,
)
from roadlang_standard.extraction.graphs.linking import attach
from roadlang_standard.extraction.graphs.tracing import trace
from tests.extraction.graph_drawings import Point, dense, graph_of, lengths, picture, surface


def test_a_line_is_traced_from_pixel_to_pixel() -> None:
    (line,) = trace(picture("......\n.####.\n......")).lines
    assert line.points.tolist() == [[1, 1], [2, 1], [3, 1], [4, 1]]
    assert line.length == 3


def test_a_line_goes_round_corners_by_sides_first() -> None:
    (line,) = trace(picture("##...\n.#...\n.#...\n.####")).lines
    ends = sorted(map(tuple, line.points[[0, -1]].tolist()))
    assert ends == [(0, 0), (4, 3)]
    assert line.length == 7


def test_three_branches_meet_in_a_node() -> None:
    graph = trace(picture("...#...\n...#...\n...#...\n#######\n......."))
    degrees = graph.degree()
    (knot,) = [node for node, count in degrees.items() if count == 3]
    assert sorted(degrees.values()) == [1, 1, 1, 3]
    assert graph.nodes[knot] == pytest.approx([3, 2.75], abs=0.3)
    tips = sorted(tuple(graph.nodes[node]) for node, count in degrees.items() if count == 1)
    assert tips == [(0, 3), (3, 0), (6, 3)]


def test_a_ring_is_traced_once_round() -> None:
    ring = np.zeros((9, 9), bool)
    ring[1, 2:7] = ring[7, 2:7] = ring[2:7, 1] = ring[2:7, 7] = True
    (line,) = trace(ring).lines
    assert line.closed
    assert len({tuple(point) for point in line.points.tolist()}) == 20
    assert line.length == pytest.approx(16 + 4 * np.sqrt(2))


def test_a_lonely_pixel_is_no_line() -> None:
    assert trace(picture("...\n.#.\n...")).lines == []


def test_the_direction_of_an_end_is_seen_over_some_length() -> None:
    """A hook of 3 px at the start does not count: from 0.35 to 1 times 20 px it goes east."""
    line = Line(1, 2, dense((0, 3), (0, 0), (60, 0)))
    assert direction(line, 0, 20.0) == pytest.approx([1, 0])
    assert direction(line, 1, 20.0) == pytest.approx([-1, 0])
    assert direction(Line(1, 2, np.array([[0.0, 0], [0, 2]])), 0, 20.0) == pytest.approx([0, 1])


@pytest.mark.parametrize(("degrees", "count"), [(19, 1), (21, 2)])
def test_lines_are_one_chain_where_they_bend_by_less_than_20_degrees(
    degrees: float, count: int
) -> None:
    turn = np.radians(degrees)
    tip = (50 + 40 * np.cos(turn), 40 * np.sin(turn))
    found = chains(graph_of(((0, 0), (50, 0)), ((50, 0), tip)), 10.0)
    assert len(found) == count


def test_the_straightest_go_on_in_each_other_at_a_crossing() -> None:
    """West to east is straight; the line from the north ends there."""
    graph = graph_of(((50, 0), (0, 0)), ((50, 0), (90, 0)), ((50, 0), (50, 30)))
    longest, other = chains(graph, 10.0)
    assert longest.length == 90
    assert other.length == 30
    assert longest.nodes in ([2, 1, 3], [3, 1, 2], [1, 0, 2], [2, 0, 1])
    points = [line.points if ahead else line.points[::-1] for line, ahead in longest.parts]
    assert points[0][-1].tolist() == points[1][0].tolist() == [50, 0]


def test_a_chain_runs_through_all_its_lines_in_order() -> None:
    """Three lines, drawn in different directions, the middle one longest."""
    graph = graph_of(((30, 0), (0, 0)), ((30, 0), (90, 0)), ((110, 0), (90, 0)))
    (chain,) = chains(graph, 10.0)
    points = np.vstack([line.points if ahead else line.points[::-1] for line, ahead in chain.parts])
    assert (np.diff(points[:, 0]) >= 0).all()
    assert (points[0, 0], points[-1, 0], chain.length) == (0, 110, 110)
    assert len(chain.nodes) == 4


def test_junctions_nearer_than_a_distance_become_one_in_the_middle() -> None:
    arms: list[tuple[Point, ...]] = [((0, 0), (-30, 20)), ((0, 0), (-30, -20)),
                                     ((8, 0), (40, 20)), ((8, 0), (40, -20))]  # fmt: skip
    for distance, nodes in ((8.1, 5), (8.0, 6)):
        graph = graph_of(*arms, ((0, 0), (8, 0)))
        contract(graph, distance)
        assert len(graph.nodes) == nodes
    graph = graph_of(*arms, ((0, 0), (8, 0)))
    contract(graph, 9.0)
    (knot,) = [node for node, count in graph.degree().items() if count == 4]
    assert graph.nodes[knot].tolist() == [4, 0]
    assert all([4.0, 0.0] in line.points[[0, -1]].tolist() for line in graph.lines)


def test_a_dead_end_is_no_bridge_between_junctions() -> None:
    graph = graph_of(((0, 0), (30, 0)), ((0, 0), (-30, 0)), ((0, 0), (0, 5)))
    contract(graph, 9.0)
    assert len(graph.lines) == 3


@pytest.mark.parametrize(("least", "left"), [(10.0, [10, 80]), (10.5, [80])])
def test_dead_ends_below_a_length_are_cut(least: float, left: list[float]) -> None:
    graph = graph_of(((0, 20), (40, 20)), ((80, 20), (40, 20)), ((40, 20), (40, 30)))
    prune(graph, least)
    total = lengths(graph)
    assert (total == [80]) if left == [80] else (total == [10, 40, 40])
    assert all(graph.degree().values())


def test_dead_ends_at_the_border_stay() -> None:
    roads: tuple[tuple[Point, ...], ...] = (
        ((20, 50), (60, 50)),
        ((60, 50), (99, 50)),
        ((60, 50), (60, 55)),
    )
    for tall, count in ((60, 3), (90, 1)):
        graph = graph_of(*roads)
        prune(graph, 20.0, (tall, 120), 5.0)
        assert len(graph.lines) == count


def test_of_two_dead_ends_at_one_place_the_shorter_goes_and_the_other_is_the_road() -> None:
    """A road of 100 px forks into 12 and 8 px: it is 112 px long without the shorter."""
    graph = graph_of(((0, 40), (100, 40)), ((100, 40), (112, 40)), ((100, 40), (100, 48)))
    prune(graph, 20.0)
    assert lengths(graph) == [112]


def test_a_line_alone_is_not_cut_however_short() -> None:
    graph = graph_of(((0, 0), (5, 0)))
    prune(graph, 50.0)
    assert lengths(graph) == [5]


@pytest.mark.parametrize(
    ("x", "y", "inside"), [(4, 20, False), (3.9, 20, True), (50, 3.9, True), (95, 20, False),
                           (95.1, 20, True), (50, 45, True), (50, 44, False)],
)  # fmt: skip
def test_the_border_of_a_picture_is_a_margin_wide(x: float, y: float, inside: bool) -> None:
    """Of a picture of 100 x 49 pixels, the last centers are at 99 and 48: 4 px from there."""
    assert at_border(np.array([x, y]), (49, 100), 4.0) == inside


def test_nothing_is_at_the_border_of_a_picture_of_unknown_size() -> None:
    assert not at_border(np.array([0.0, 0.0]), None, 4.0)


@pytest.mark.parametrize(("least", "count"), [(62.0, 2), (64.0, 1)])
def test_loops_at_a_junction_go_below_a_length(least: float, count: int) -> None:
    angle = np.linspace(0, 2 * np.pi, 361)
    ring = np.column_stack([10 * np.cos(angle) - 10, 10 * np.sin(angle)])
    graph = graph_of(((0, 0), (50, 0)))
    graph.lines.append(Line(graph.lines[0].start, graph.lines[0].start, ring))
    drop_loops(graph, least)
    assert len(graph.lines) == count


def test_a_ring_by_itself_is_no_loop_at_a_junction() -> None:
    angle = np.linspace(0, 2 * np.pi, 61)
    ring = Line(0, 0, np.column_stack([np.cos(angle), np.sin(angle)]))
    graph = Graph({0: np.array([1.0, 0.0])}, [ring])
    drop_loops(graph, 100.0)
    assert graph.lines == [ring]


def test_two_lines_that_meet_alone_are_one() -> None:
    """What was bridged of each counts by its length: 0.3 of 40 px and none of 60 are 0.12."""
    graph = graph_of(((40, 0), (0, 0)), ((100, 0), (40, 0)))
    graph.lines[0].linked = 0.3
    join(graph)
    (line,) = graph.lines
    assert line.length == 100
    assert line.linked == pytest.approx(0.12)
    assert sorted(line.points[[0, -1], 0].tolist()) == [0, 100]
    assert len(graph.nodes) == 2


def test_three_lines_that_meet_stay_three() -> None:
    graph = graph_of(((0, 0), (40, 0)), ((40, 0), (80, 0)), ((40, 0), (40, 40)))
    join(graph)
    assert len(graph.lines) == 3


@pytest.mark.parametrize(("corners", "goal"), [
    (((50, 40), (50, 8)), (50, -0.5)), (((50, 40), (8, 40)), (-0.5, 40)),
    (((50, 40), (93, 40)), (99.5, 40)), (((50, 40), (50, 73)), (50, 79.5)),
])  # fmt: skip
def test_a_road_that_ends_near_the_border_goes_straight_on_to_it(
    corners: tuple[Point, Point], goal: Point
) -> None:
    graph = graph_of(corners)
    extend_to_border(graph, (80, 100), 10.0)
    assert graph.nodes[graph.lines[0].end] == pytest.approx(goal)
    assert graph.lines[0].points[-1] == pytest.approx(goal)
    assert graph.lines[0].points[0].tolist() == [50, 40]


def test_a_hook_at_the_border_is_cut_before_the_road_goes_on() -> None:
    """The skeleton of a wide road turns to a corner of its mask: 6 px to the side at the end."""
    graph = graph_of(((50, 70), (50, 10), (44, 4)))
    extend_to_border(graph, (80, 100), 10.0)
    assert graph.nodes[graph.lines[0].end] == pytest.approx([50, -0.5], abs=1.0)


def test_a_road_that_ends_within_the_picture_stays() -> None:
    graph = graph_of(((50, 60), (50, 20)))
    extend_to_border(graph, (80, 100), 10.0)
    assert graph.lines[0].points[-1].tolist() == [50, 20]


def test_a_road_that_is_seen_to_end_before_the_border_stays() -> None:
    """It leaves where its surface ends at most half of the 10 px and one before the border."""
    graph = graph_of(((20, 40), (91, 8)))
    ends = surface(80, 100, (slice(0, 80), slice(0, 92))) > 0
    extend_to_border(graph, (80, 100), 10.0, surface=ends)
    assert graph.lines[0].points[-1].tolist() == [91, 8]
    near = surface(80, 100, (slice(0, 80), slice(0, 96))) > 0
    extend_to_border(graph, (80, 100), 10.0, surface=near)
    assert graph.lines[0].points[-1, 0] == pytest.approx(99.5)


def test_a_road_along_the_border_does_not_leave_far_away() -> None:
    """It would leave 57 px ahead, more than 3.5 times the 10 px."""
    graph = graph_of(((10, 5), (43, 5)))
    extend_to_border(graph, (80, 100), 10.0)
    assert graph.lines[0].points[-1, 0] <= 43


def test_parts_that_do_not_touch_are_counted_apart() -> None:
    graph = graph_of(((0, 0), (9, 0)), ((9, 0), (9, 9)), ((50, 0), (60, 0)))
    assert sorted(len(part) for part in components(graph)) == [1, 2]
    drop_crumbs(graph, 18.0)
    assert lengths(graph) == [9, 9]
    assert len(graph.nodes) == 3
    drop_crumbs(graph, 18.1)
    assert graph.lines == []


def test_a_line_is_met_at_its_end_if_that_is_near() -> None:
    for x, new in ((97.0, False), (50.0, True), (95.0, True)):
        graph = graph_of(((0, 0), (100, 0)))
        node = attach(graph, graph.lines[0], np.array([x, 3.0]))
        assert (len(graph.lines) == 2) == new
        assert graph.nodes[node].tolist() == ([x, 0] if new else [100, 0])
        if new:
            assert lengths(graph) == sorted([x, 100 - x])


def test_dead_ends_look_ahead_and_those_at_the_border_are_none() -> None:
    graph = graph_of(((30, 40), (99, 40)))
    (end,) = dead_ends(graph, (80, 100))
    assert (end.place.tolist(), end.side, end.line) == ([30, 40], 0, 0)
    assert end.ahead == pytest.approx([-1, 0])


@pytest.mark.parametrize("turned", [1.0, -1.0])
@pytest.mark.parametrize("look", [12.0, 30.0])
def test_a_bent_line_leaves_both_its_ends_along_its_tangents(turned: float, look: float) -> None:
    """An arc of 1.4 rad around (0, 0): where it leaves its ends is known."""
    angle = turned * np.linspace(0.3, 1.7, 330)
    arc = 240.0 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    line = Line(0, 1, arc)
    for side, at in ((0, angle[0]), (1, angle[-1])):
        away = (1.0 if side == 0 else -1.0) * turned
        tangent = away * np.array([-np.sin(at), np.cos(at)])
        assert heading(line, side, look) @ tangent > np.cos(0.02)
        assert direction(line, side, look) @ tangent > np.cos(0.2)
        assert np.hypot(*heading(line, side, look)) == pytest.approx(1.0)


def test_a_short_line_leaves_its_ends_toward_each_other() -> None:
    line = Line(0, 1, np.array([[5.0, 1.0], [6.0, 2.0], [7.0, 3.0]]))
    for side in (0, 1):
        toward = np.array([1.0, 1.0]) / np.sqrt(2.0) * (1 - 2 * side)
        assert heading(line, side, 20.0) == pytest.approx(toward)


@pytest.mark.parametrize(
    ("at", "node"), [((-9.0, 1.0), 0), ((3.0, 1.0), 0), ((40.0, 1.0), 1), ((30.0, 0.0), 1)]
)
def test_a_line_is_not_split_at_its_end_though_its_node_is_elsewhere(at: Point, node: int) -> None:
    points = dense((0.0, 0.0), (30.0, 0.0))
    nodes = {0: np.array([-20.0, 0.0]), 1: np.array([50.0, 0.0])}
    graph = Graph(nodes, [Line(0, 1, points)])
    near = at[0] if 0.0 < at[0] < 30.0 else 0.0
    split = attach(graph, graph.lines[0], np.array(at))
    if near:
        assert (split, len(graph.lines)) == (2, 2)
        assert graph.nodes[split].tolist() == [near, 0.0]
        assert [(line.start, line.end) for line in graph.lines] == [(0, 2), (2, 1)]
    else:
        assert (split, len(graph.lines)) == (node, 1)
