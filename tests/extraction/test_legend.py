"""Typed grids and drawings with a legend are read exactly."""

import numpy as np
import pytest

from roadlang_standard.extraction.colors.colors import bgr
from roadlang_standard.extraction.legends.legend import read_colors, read_text

TOWN = ("..###..", "..#.T#.", ".##..#.", "..####.")
LEGEND = {"#": "road", "T": "tree"}


def test_a_typed_town_is_read_cell_by_cell() -> None:
    found, things = read_text(TOWN, LEGEND)
    assert [(thing.kind, thing.x, thing.y) for thing in things] == [("tree", 4, 1)]
    points = {tuple(p) for road in found.roads for p in road.points}
    assert points == {(x, y) for y, row in enumerate(TOWN) for x, c in enumerate(row) if c == "#"}


def test_corners_join_only_where_no_side_does() -> None:
    found, _ = read_text(("#..", ".#.", "..#"), LEGEND)
    (road,) = found.roads
    assert road.points.tolist() == [[0, 0], [1, 1], [2, 2]]


def test_a_ring_is_a_closed_road() -> None:
    found, _ = read_text((".##.", "#..#", ".##."), LEGEND)
    assert [road.closed for road in found.roads] == [True]


def test_a_drawn_town_has_roads_and_things_of_its_colors() -> None:
    image = np.full((60, 80, 3), (50, 120, 40), np.uint8)
    image[27:33] = 255
    image[5:11, 20:30] = (28, 28, 183)
    image[45:51, 60:66] = (28, 28, 183)
    found, things = read_colors(image, {"white": "road", "#b71c1c": "building"})
    (road,) = found.roads
    assert np.abs(road.points[:, 1] - 29.5).max() < 0.1
    assert np.median(road.widths) == pytest.approx(6, abs=0.2)
    assert [(t.kind, t.x, t.y, t.length, t.width) for t in things] == [
        ("building", 24.5, 7.5, 10, 6),
        ("building", 62.5, 47.5, 6, 6),
    ]


@pytest.mark.parametrize(
    ("name", "color"),
    [
        ("#2e7d32", (0x32, 0x7D, 0x2E)),
        ("#f80", (0x00, 0x88, 0xFF)),
        ("White", (255, 255, 255)),
        (" navy ", (128, 0, 0)),
    ],
)
def test_a_color_is_blue_green_and_red(name: str, color: tuple[int, int, int]) -> None:
    assert bgr(name) == color


@pytest.mark.parametrize("name", ["mauve", "2e7d32", "#12345", "#"])
def test_what_is_no_color_is_refused(name: str) -> None:
    with pytest.raises(ValueError, match="is not a color"):
        bgr(name)
