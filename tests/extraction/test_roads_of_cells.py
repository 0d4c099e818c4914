"""Roads drawn one or two cells wide."""

from __future__ import annotations

import pytest

from roadlang_standard.extraction.legends.grid import roads_of_cells
from tests.extraction.graph_drawings import picture


def test_cells_that_touch_by_their_sides_are_roads() -> None:
    """A T of cells: three roads from its middle, of 2, 2 and 2 cells' length."""
    found = roads_of_cells(picture("#####\n..#..\n..#.."), 3.0)
    assert sorted(road.length for road in found.roads) == [2, 2, 2]
    assert all(road.widths.tolist() == [3.0] * 3 for road in found.roads)
    ends = {tuple(found.nodes[node]) for road in found.roads for node in (road.start, road.end)}
    assert ends == {(0, 0), (4, 0), (2, 2), (2, 0)}


def test_a_ring_of_cells_is_a_closed_road() -> None:
    (road,) = roads_of_cells(picture(".#.\n#.#\n.#.")).roads
    assert road.closed
    assert len(road.points) == 5


def test_two_rings_of_cells_are_two_roads() -> None:
    found = roads_of_cells(picture(".#...#.\n#.#.#.#\n.#...#."))
    assert [road.closed for road in found.roads] == [True, True]


@pytest.mark.parametrize(
    ("text", "lengths", "node"),
    [
        ("########\n########", [7], (7, 0.5)),
        ("##....\n##....\n######\n######", [7], (5, 2.5)),
        ("..##\n..##\n####\n####\n..##\n..##", [2.5, 2.5, 2.5], (2.5, 2.5)),
        ("..##..\n..##..\n######\n######\n..##..\n..##..", [2.5, 2.5, 2.5, 2.5], (2.5, 2.5)),
        ("#####\n#####\n##.##\n#####\n#####", [12], (0.5, 0.5)),
        (".#....\n######\n######", [1.58, 1.5, 3.5], (1.5, 1.5)),
        ("##...\n###..\n.###.\n..###\n...##", [5.66], (4, 4)),
    ],
    ids=["straight", "corner", "tee", "cross", "ring", "into a road of one", "diagonal"],
)
def test_roads_of_two_cells_are_one_road(
    text: str, lengths: list[float], node: tuple[float, float]
) -> None:
    found = roads_of_cells(picture(text))
    assert sorted(road.length for road in found.roads) == pytest.approx(sorted(lengths), abs=0.01)
    assert node in {tuple(place) for place in found.nodes}
    assert found.has_widths
    assert max(road.widths.max() for road in found.roads) == 2.0


def test_a_square_of_four_cells_is_no_road() -> None:
    assert roads_of_cells(picture("....\n.##.\n.##.")).roads == ()


def test_a_cell_alone_is_no_road() -> None:
    assert roads_of_cells(picture("...\n.#.")).roads == ()
