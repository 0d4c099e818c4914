"""A stranger's extractor gives polylines; their ends become the nodes of a network."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang.geometry import GeometryError, network_of_polylines
from roadlang.geometry.networks.polylines import DEFAULT_WIDTH
from roadlang.ir.picture import Picture


def line(*points: tuple[float, float]) -> np.ndarray:
    return np.array(points, dtype=float)


def test_three_lines_that_meet_share_a_node() -> None:
    network = network_of_polylines(
        [
            line((0, 0), (50, 0)),
            line((50.2, 0.1), (100, 0)),
            line((49.9, 0), (50, 40)),
        ],
        tolerance=0.5,
    )
    assert [network.degree(node.id) for node in network.nodes] == [1, 3, 1, 1]
    assert network.edge(2).start == network.edge(1).end
    assert set(network.edge(1).widths) == {DEFAULT_WIDTH}


def test_a_line_that_ends_where_it_began_is_a_loop() -> None:
    network = network_of_polylines([line((0, 0), (40, 0), (40, 40), (0, 40), (0, 0))])
    [loop] = network.edges
    assert loop.curve.closed
    assert loop.start == loop.end


def test_no_lines_make_an_empty_network() -> None:
    assert network_of_polylines([]).edges == ()


def test_a_loop_of_three_points_is_no_loop_but_there_and_back_again() -> None:
    [edge] = network_of_polylines([line((0, 0), (40, 0), (0, 1e-9))]).edges
    assert not edge.curve.closed
    assert edge.start == edge.end


def test_ends_as_far_apart_as_the_tolerance_are_joined_and_no_farther() -> None:
    for gap, nodes in ((0.5, 3), (0.501, 4)):
        apart = [line((0, 0), (50, 0)), line((50 + gap, 0), (100, 0))]
        network = network_of_polylines(apart, tolerance=0.5)
        assert len(network.nodes) == nodes
        assert network.edge(1).curve.points[-1, 0] == 50 + (gap / 2 if nodes == 3 else 0)


def test_widths_are_of_all_lines_or_of_each() -> None:
    lines = [line((0, 0), (50, 0)), line((50, 0), (50, 90))]
    assert network_of_polylines(lines, 6).edge(2).width.at(10.0) == 6.0
    network = network_of_polylines(lines, [5.0, [4.0, 8.0]])
    assert network.edge(1).width.at(25.0) == 5.0
    assert network.edge(2).width.at([0.0, 45.0, 90.0]) == pytest.approx([4.0, 6.0, 8.0])


@pytest.mark.parametrize(
    ("lines", "options", "reason"),
    [
        ([[(1, 1), (1, 1)]], {}, "distinct"),
        ([[(1, 1)]], {}, "polyline 0 has"),
        ([[]], {}, "polyline 0 has"),
        ([[(0, 0), (9, 9)], [(0, 0), (np.nan, 1)]], {}, "polyline 1 must be finite"),
        ([[(0, 0), (np.inf, 1)]], {}, "finite"),
        ([[(0, 0, 0), (1, 1, 1)]], {}, "pairs"),
        ([["a", "b"]], {}, "numbers"),
        ([[(0, 0), (9, 9)]], {"width": 0.0}, "positive"),
        ([[(0, 0), (9, 9)]], {"width": -3.0}, "positive"),
        ([[(0, 0), (9, 9)]], {"width": [[]]}, "positive"),
        ([[(0, 0), (9, 9)]], {"width": [3.0, 4.0]}, "1 lines need as many widths, not 2"),
        ([[(0, 0), (9, 9)]], {"width": np.nan}, "positive, but it is nan m"),
        ([[(0, 0), (9, 9)]], {"tolerance": -1.0}, "tolerance"),
        ([[(0, 0), (9, 9)]], {"tolerance": np.nan}, "tolerance"),
    ],
)
def test_what_is_no_network_is_refused(lines: Any, options: Any, reason: str) -> None:
    with pytest.raises(GeometryError, match=reason):
        network_of_polylines(lines, **options)


def test_pictures_turn_pixels_into_meters_with_y_up() -> None:
    picture = Picture(np.zeros((100, 200, 3), np.uint8), scale=0.5)
    extraction = picture.network([line((-0.5, 99.5), (199.5, 99.5))], width=14)
    [edge] = extraction.network.edges
    assert edge.curve.at(np.array([0.0, 100.0])) == pytest.approx(line((0, 0), (100, 0)))
    assert edge.widths == pytest.approx([7, 7])
    assert picture.to_pixels(picture.to_world(line((3, 4)))) == pytest.approx(line((3, 4)))


def test_a_long_leg_beside_a_short_one_does_not_bulge() -> None:
    [road] = network_of_polylines([line((0, 0), (200, 0), (204, 3), (404, 3))]).edges
    points = road.curve.at(np.linspace(0.0, road.curve.length, 2000))
    assert points[:, 1].min() > -0.5
    assert points[:, 1].max() < 3.5
