"""Networks, ways through them, and keeping them joined."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import (
    Arc,
    Curve,
    Edge,
    GeometryError,
    Node,
    RoadNetwork,
    Straight,
    anchored_nodes,
    chain,
    displace,
    junction_window,
)
from tests.geometry.geometry_shapes import circle


def network(places: Any, roads: Any) -> Any:
    """Straight roads 8 m wide between `places` {id: (x, y)}."""
    nodes = tuple(Node(id, position) for id, position in places.items())
    edges = tuple(
        Edge(number, a, b, Curve.through([places[a], places[b]]), np.array([8.0]))
        for number, (a, b) in enumerate(roads, start=1)
    )
    return RoadNetwork(nodes, edges)


def tee() -> Any:
    """A road from west to east, one from its middle to the north."""
    places = {1: (0.0, 0.0), 2: (60.0, 0.0), 3: (150.0, 0.0), 4: (60.0, 80.0)}
    return network(places, [(1, 2), (2, 3), (2, 4)])


def block() -> Any:
    """A square of streets with a street across, 100 m a side."""
    places = {1: (0.0, 0.0), 2: (100.0, 0.0), 3: (100.0, 100.0), 4: (0.0, 100.0)}
    return network(places, [(1, 2), (2, 3), (3, 4), (4, 1)])


def ring() -> Any:
    curve = circle(radius=30.0)
    x, y = curve.points[0]
    return RoadNetwork((Node(1, (x, y)),), (Edge(1, 1, 1, curve, np.array([6.0, 8.0])),))


def test_degrees_components_length_and_bounds() -> None:
    town = tee()
    assert [town.degree(node.id) for node in town.nodes] == [1, 3, 1, 1]
    assert town.length == pytest.approx(230.0)
    assert town.bounds == pytest.approx((0.0, 0.0, 150.0, 80.0))
    assert town.components == (frozenset({1, 2, 3, 4}),)
    apart = network({1: (0, 0), 2: (9, 0), 3: (0, 9), 4: (9, 9), 5: (50, 50)}, [(1, 2), (3, 4)])
    assert apart.components == (frozenset({1, 2}), frozenset({3, 4}), frozenset({5}))


def test_a_loop_counts_twice_at_its_node() -> None:
    assert ring().degree(1) == 2


def test_the_bounds_of_a_bent_road_include_its_bulge() -> None:
    bend = chain([Arc(50.0, np.pi)]).curve()
    ends = Node(1, (0.0, 0.0)), Node(2, tuple(bend.points[-1]))
    assert RoadNetwork(ends, (Edge(1, 1, 2, bend, np.array([8.0])),)).bounds[2] > 49.9


@given(st.floats(0.01, 100.0))
def test_scaling_scales_places_lengths_and_widths(factor: float) -> None:
    town = tee().scaled(factor)
    assert town.length == pytest.approx(230.0 * factor)
    assert town.node(3).position == pytest.approx((150.0 * factor, 0.0))
    assert float(town.edge(1).width.at(0.0)) == pytest.approx(8.0 * factor)


def test_pixels_with_y_down_become_meters_with_y_up() -> None:
    town = tee().transformed([[0.5, 0.0], [0.0, -0.5]], (0.0, 40.0), width_factor=0.5)
    assert town.node(4).position == pytest.approx((30.0, 0.0))
    assert town.node(1).position == pytest.approx((0.0, 40.0))


def test_the_longest_road_passes_straight_through_a_junction() -> None:
    path = tee().longest()
    assert set(path.edges) == {2, 3}
    assert path.length == pytest.approx(170.0)


def test_the_longest_road_is_not_the_longest_edge_only() -> None:
    places = {i: (50.0 * i, 0.0) for i in range(6)}
    assert network(places, [(i, i + 1) for i in range(5)]).longest().length == pytest.approx(250.0)


def test_the_longest_road_of_a_block_uses_three_sides() -> None:
    assert block().longest().length == pytest.approx(300.0)


def test_a_road_does_not_turn_back_sharply_at_a_junction() -> None:
    places = {1: (0.0, 0.0), 2: (100.0, 0.0), 3: (0.0, 20.0)}
    assert network(places, [(1, 2), (2, 3)]).longest().edges == (2,)


def test_a_ring_is_a_closed_road() -> None:
    path = ring().longest()
    assert path.curve.closed
    assert path.road().closed
    assert path.curve.length == pytest.approx(60.0 * np.pi, rel=1e-6)


def test_the_longest_road_of_a_big_grid_is_found_in_time_and_is_simple() -> None:
    size = 12
    places = {i: (40.0 * (i % size), 40.0 * (i // size)) for i in range(size * size)}
    roads = [(i, i + 1) for i in places if i % size < size - 1]
    roads += [(i, i + size) for i in places if i < size * (size - 1)]
    path = network(places, roads).longest()
    assert len(set(path.edges)) == len(path.edges)
    assert path.length > 40.0 * 2 * size


def test_a_route_takes_the_shorter_way() -> None:
    path = block().route((0.0, 70.0), (60.0, 0.0))
    assert path.edges == (4, 1)
    assert path.length == pytest.approx(130.0)


def test_a_route_within_one_road_may_run_against_it() -> None:
    path = tee().route((140.0, 5.0), (80.0, -3.0))
    assert path.edges == (2,)
    np.testing.assert_allclose(path.curve.at([0.0, path.curve.length]), [(140, 0), (80, 0)])


def test_a_route_on_a_ring_goes_the_short_way_round() -> None:
    path = ring().route((0.0, -30.0), (0.0, 30.0))
    assert path.length == pytest.approx(30.0 * np.pi, rel=1e-4)
    short = ring().route((25.0, -10.0), (25.0, 10.0))
    assert short.length == pytest.approx(2 * 30.0 * np.arctan2(10, 25), rel=1e-3)
    assert len(short.steps) == 2


def test_a_route_s_corners_are_rounded_and_the_rest_is_the_roads() -> None:
    path = tee().route((10.0, 0.0), (60.0, 70.0))
    curve = path.curve
    s = curve.stations(count=2000)
    assert np.abs(curve.curvature(s)).max() < 0.3
    assert curve.length < path.length
    points = curve.at(s)
    straight = (points[:, 0] < 55.0) | (points[:, 1] > 5.0)
    on_road = np.minimum(np.abs(points[:, 1]), np.abs(points[:, 0] - 60.0))
    np.testing.assert_allclose(on_road[straight], 0.0, atol=1e-9)
    assert path.width.at(curve.length / 2) == 8.0


def test_without_a_corner_a_path_is_exactly_its_roads() -> None:
    path = network({1: (0, 0), 2: (50, 0), 3: (90, 0)}, [(1, 2), (3, 2)]).longest()
    assert path.curve.length == pytest.approx(90.0, rel=1e-12)
    assert np.abs(path.curve.curvature(path.curve.stations(count=99))).max() < 1e-12


def test_widths_follow_the_roads_of_a_path() -> None:
    plain = network({1: (0, 0), 2: (50, 0), 3: (90, 0)}, [(1, 2), (3, 2)])
    wide = Edge(2, 3, 2, plain.edge(2).curve, np.array([4.0, 6.0]))
    path = RoadNetwork(plain.nodes, (plain.edge(1), wide)).route((0, 0), (90, 0))
    np.testing.assert_allclose(path.width.at([10.0, 49.0, 51.0, 90.0]), [8, 8, 5.95, 4], atol=1e-2)


@pytest.mark.parametrize(
    "ask",
    [
        lambda: tee().route((0, 0), (0, 0)),
        lambda: tee().route((0, 0), (0, 0, 0)),
        lambda: tee().edge(9),
        lambda: tee().node(9),
        lambda: tee().scaled(0.0),
        lambda: RoadNetwork((), ()).longest(),
        lambda: RoadNetwork((), ()).route((0, 0), (1, 1)),
        lambda: RoadNetwork((), ()).bounds,
        lambda: network({1: (0, 0), 2: (9, 0), 3: (0, 9), 4: (9, 9)}, [(1, 2), (3, 4)]).route(
            (0, 0), (9, 9)
        ),
        lambda: RoadNetwork((Node(1, (0, 0)),), tee().edges),
        lambda: RoadNetwork((Node(1, (0, 0)), Node(2, (61, 0))), tee().edges[:1]),
        lambda: RoadNetwork(tee().nodes * 2, tee().edges),
    ],
)
def test_what_a_network_cannot_do_is_said(ask: Any) -> None:
    with pytest.raises(GeometryError):
        ask()


def test_displacements_vanish_at_junctions_but_not_at_dead_ends() -> None:
    town = tee()
    edge = town.edge(3)
    s = edge.curve.stations(spacing=1.0)
    window = junction_window(town, edge, s)
    assert window[0] == 0.0
    assert (window[s >= 15.0] == 1.0).all()
    np.testing.assert_array_equal(junction_window(town, edge, s, taper=5.0)[s >= 5.0], 1.0)
    displaced = displace(edge.curve, s, 3.0 * window)
    np.testing.assert_array_equal(displaced.points[0, 0], town.node(2).position)
    assert displaced.heading[0, 0] == pytest.approx(np.pi / 2, abs=0.02)


def test_a_ring_by_itself_needs_no_taper() -> None:
    town = ring()
    edge = town.edge(1)
    assert anchored_nodes(town) == frozenset()
    assert (junction_window(town, edge, edge.curve.stations(spacing=1.0)) == 1.0).all()


def test_a_straight_piece_and_an_arc_make_a_smooth_join() -> None:
    first = chain([Straight(30.0)]).curve()
    second = chain([Arc(20.0, 1.0)], start=(30.0, 0.0)).curve()
    ends = [(0.0, 0.0), (30.0, 0.0), tuple(second.points[-1])]
    nodes = tuple(Node(i, place) for i, place in enumerate(ends))
    edges = Edge(1, 0, 1, first, np.array([8.0])), Edge(2, 1, 2, second, np.array([8.0]))
    curve = RoadNetwork(nodes, edges).longest().curve
    assert curve.length == pytest.approx(50.0, rel=1e-9)
