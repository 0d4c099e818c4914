"""A stranger's extractor gives polylines; their ends become the nodes of a network."""

import numpy as np
import pytest

from roadlang.geometry import GeometryError
from roadlang.ir.picture import Picture
from roadlang.ir.polylines import DEFAULT_WIDTH, network_of_polylines


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


def test_a_line_without_extent_is_refused() -> None:
    with pytest.raises(GeometryError):
        network_of_polylines([line((1, 1), (1, 1))])


def test_pictures_turn_pixels_into_meters_with_y_up() -> None:
    picture = Picture(np.zeros((100, 200, 3), np.uint8), scale=0.5)
    extraction = picture.network([line((-0.5, 99.5), (199.5, 99.5))], width=14)
    [edge] = extraction.network.edges
    assert edge.curve.at(np.array([0.0, 100.0])) == pytest.approx(line((0, 0), (100, 0)))
    assert edge.widths == pytest.approx([7, 7])
    assert picture.to_pixels(picture.to_world(line((3, 4)))) == pytest.approx(line((3, 4)))
