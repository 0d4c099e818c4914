"""Lines painted on a drawn road are part of it; what parts two roads is not."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang.api import Picture
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extraction.drawings.road_markings import with_markings_filled
from tests.extraction.graph_drawings import surface
from tests.extraction.painted_roads import band, painted

_DASHES = [(slice(64, 67), slice(start, start + 16)) for start in range(10, 380, 28)]


def _dashed() -> np.ndarray:
    """A road of rows 50 to 80 with dashes along its middle."""
    return np.asarray(band(50, 81, 130, 400) - surface(130, 400, *_DASHES))


def test_dashes_are_filled() -> None:
    assert np.array_equal(with_markings_filled(_dashed()), band(50, 81, 130, 400))


def test_dashes_are_filled_though_each_alone_is_too_thick() -> None:
    """A fourth as thick as the road: one is an island, many are dashes."""
    dashes = [(slice(62, 69), slice(start, start + 16)) for start in range(10, 380, 28)]
    road = band(50, 81, 130, 400)
    assert np.array_equal(with_markings_filled(road - surface(130, 400, *dashes)), road)
    one = road - surface(130, 400, dashes[5])
    assert with_markings_filled(one) is one


@pytest.mark.parametrize("gap", [slice(61, 70), slice(58, 73)])
def test_a_wide_gap_between_two_roads_stays(gap: slice) -> None:
    apart = band(50, 81, 130, 400) - surface(130, 400, (gap, slice(20, 380)))
    assert with_markings_filled(apart) is apart


def test_a_block_between_streets_stays() -> None:
    block = band(20, 110, 130, 400) - surface(130, 400, (slice(30, 100), slice(20, 60)))
    assert with_markings_filled(block) is block


def _town(streets: int) -> np.ndarray:
    """So many streets of 4 pixels each way, dark (480, 480), from border to border."""
    town = np.zeros((480, 480), np.float32)
    for middle in np.linspace(0, 480, streets + 1)[:-1].astype(int) + 240 // streets:
        town[middle - 2 : middle + 2] = town[:, middle - 2 : middle + 2] = 1.0
    return town


def test_the_many_blocks_of_a_town_stay() -> None:
    """Were all of them filled, what is left would be one wide road."""
    assert with_markings_filled(_town(12)).sum() == _town(12).sum()


def test_a_town_of_many_streets_is_its_streets_not_its_blocks() -> None:
    network = Auto().extract(Picture(painted(_town(12), 60, 255), 1.0)).network
    assert len(network.edges) == 2 * 12 * 13
    assert sum(edge.length for edge in network.edges) == pytest.approx(2 * 12 * 480, rel=0.01)


@pytest.mark.parametrize("marking", [255, 200])
def test_a_gray_road_with_a_dashed_middle_is_one_road(marking: int) -> None:
    image = painted(_dashed(), road=90, ground=marking)
    image[:50] = image[81:] = (90, 160, 80) if marking == 200 else (255, 255, 255)
    (road,) = Auto().extract(Picture(image, 1.0)).network.edges
    middle = Picture(image, 1.0).to_pixels(road.curve.at(np.linspace(0, road.length, 50)))
    assert np.abs(middle[:, 1] - 65).max() < 0.6
    assert road.width.at(road.length / 2) == pytest.approx(31, abs=0.6)


def _lined(line: slice, color: tuple[int, int, int]) -> np.ndarray:
    """A gray road of rows 50 to 80 on white, from border to border, with a line along it."""
    image = np.full((400, 400, 3), 255, np.uint8)
    image[50:81], image[line] = (60, 60, 60), color
    return image


@pytest.mark.parametrize(
    ("line", "color", "roads"),
    [
        (slice(64, 67), (255, 255, 255), 1),
        (slice(61, 70), (255, 255, 255), 2),
        (slice(62, 69), (0, 220, 255), 1),
    ],
    ids=["thin", "a gap", "wider, but yellow"],
)
def test_a_line_along_the_middle_is_a_marking_if_it_is_thin_or_has_a_color(
    line: slice, color: tuple[int, int, int], roads: int
) -> None:
    image = _lined(line, color)
    dark = (image.max(axis=2) < 128).astype(np.float32)
    found = with_markings_filled(dark, image)
    assert bool((found[65] > 0.5).all()) == (roads == 1)


def test_colored_letters_beside_a_road_are_no_road() -> None:
    image = _lined(slice(50, 50), (0, 0, 0))
    image[30:33, 100:130] = (0, 0, 220)
    dark = (image.max(axis=2) < 128).astype(np.float32)
    assert with_markings_filled(dark, image) is dark


def test_lanes_are_one_road_with_the_lines_along_its_edges() -> None:
    """A road of rows 40 to 119: a double line in the middle, dashes, and edge lines 4 px from its
    edges."""
    road = band(40, 120, 160, 400)
    for line in (slice(44, 46), slice(76, 78), slice(82, 84), slice(114, 116)):
        road = road - surface(160, 400, (line, slice(0, 400)))
    dashes = [
        (slice(row, row + 2), slice(x, x + 14)) for row in (60, 98) for x in range(5, 390, 30)
    ]
    assert np.array_equal(
        with_markings_filled(road - surface(160, 400, *dashes)), band(40, 120, 160, 400)
    )
