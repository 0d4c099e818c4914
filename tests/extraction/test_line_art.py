"""Line art is no sure road: its lines end on one another, within the picture, or vary in width."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.doubts.line_art import sure_by_junctions, sure_by_widths
from roadlang_standard.extraction.drawings.drawing import roads_of_drawing
from roadlang_standard.extraction.drawings.surface_roads import Cover, roads_of_surface
from roadlang_standard.extraction.networks.found_network import FoundNetwork, FoundRoad

_Stroke = tuple[tuple[int, int], tuple[int, int]]


def _drawn(lines: list[_Stroke], circles: Sequence[tuple[int, int]] = ()) -> np.ndarray:
    width = 10 + max(x for line in lines for x, _ in line)
    image = np.full((600, max(900, width), 3), 255, np.uint8)
    for start, end in lines:
        cv2.line(image, start, end, (40, 40, 40), 6, cv2.LINE_AA)
    for center in circles:
        cv2.circle(image, center, 36, (40, 40, 40), 6, cv2.LINE_AA)
    return image


def _surest(found: FoundNetwork) -> float:
    return max(road.confidence for road in found.roads)


def _side_streets(count: int) -> list[_Stroke]:
    sides = [(90 + 80 * k, 60 if k % 2 else 540) for k in range(count)]
    return [((40, 300), (60 + 80 * count, 300)), *(((x, 300), (x, y)) for x, y in sides)]


def test_a_family_tree_is_no_sure_road() -> None:
    """Three generations: each line ends on a person or on another line."""
    rows = {300: (75, 225, 375, 525, 675, 825), 500: (150, 300, 450, 600, 750)}
    people = [(x, y) for y, row in rows.items() for x in row]
    lines = [((75, 180), (825, 180)), ((450, 60), (450, 180))]
    lines += [((x, 180), (x, 264)) for x in rows[300]]
    lines += [((150, 400), (750, 400)), ((450, 300), (450, 400)), ((411, 300), (489, 300))]
    lines += [((x, 400), (x, 464)) for x in rows[500]]
    found = roads_of_drawing(_drawn(lines, circles=people))
    assert 0 < _surest(found) < 0.5


@pytest.mark.parametrize("count", [3, 6, 12])
def test_side_streets_on_a_sheet_with_margins_are_sure(count: int) -> None:
    found = roads_of_drawing(_drawn(_side_streets(count)))
    assert len(found.roads) >= 2 * count
    assert _surest(found) > 0.95


def test_very_many_side_streets_are_sure_where_they_leave_the_picture_or_cross() -> None:
    inside = roads_of_drawing(_drawn(_side_streets(20)))
    leaving = [(a, (b[0], -5 if b[1] < 300 else 605)) for a, b in _side_streets(20)[1:]]
    beyond = roads_of_drawing(_drawn([((-5, 300), (1705, 300)), *leaving]))
    across = [((x, 60), (x, 540)) for x in range(90, 1690, 80)]
    crossing = roads_of_drawing(_drawn([((40, 300), (1660, 300)), *across]))
    assert _surest(inside) < 0.7
    assert _surest(beyond) > 0.95
    assert _surest(crossing) > 0.95


def _road(start: int, end: int, points: list[tuple[int, int]], widths: list[float]) -> FoundRoad:
    return FoundRoad(start, end, np.array(points, float), np.array(widths, float))


def test_barbs_on_a_line_count_as_lines_that_end_on_it() -> None:
    shape = (400, 1800)
    count = 12
    places = [(100 + 100 * k, 200) for k in range(count + 2)]
    line = [_road(k, k + 1, places[k : k + 2], [5, 5]) for k in range(count + 1)]
    barbs = {
        length: [
            _road(k + 1, 100 + k, [places[k + 1], (places[k + 1][0], 200 - length)], [5, 5])
            for k in range(count)
        ]
        for length in (10, 100)
    }
    assert sure_by_junctions([*line, *barbs[100]], shape) == 1.0
    assert sure_by_junctions([*line, *barbs[10]], shape) < 0.5


def test_many_roads_of_uneven_width_are_cracks_and_a_few_are_strokes_of_a_pen() -> None:
    def roads(count: int, widths: list[float]) -> list[FoundRoad]:
        return [_road(2 * k, 2 * k + 1, [(0, 9 * k), (99, 9 * k)], widths) for k in range(count)]

    assert sure_by_widths(roads(12, [4, 4.4]), 600) == 1.0
    assert sure_by_widths(roads(12, [3, 5]), 600) < 0.1
    assert sure_by_widths(roads(4, [3, 5]), 600) == 1.0


def test_no_pen_is_so_broad_that_a_few_broad_lines_may_be_uneven() -> None:
    def road(*widths: float) -> list[FoundRoad]:
        return [_road(0, 1, [(0, 9), (99, 9)], list(widths))]

    assert sure_by_widths(road(26, 34), 600) < 0.5
    assert sure_by_widths(road(29, 31), 600) == 1.0
    assert sure_by_widths(road(26, 34), 6000) == 1.0


def test_streets_whose_color_is_stated_are_sure_however_they_meet() -> None:
    surface = np.zeros((600, 1700), np.float32)
    for start, end in _side_streets(20):
        cv2.line(surface, start, end, 1.0, 12)
    assert _surest(roads_of_surface(surface, "legend")) > 0.95
    assert _surest(roads_of_surface(surface, "filled road")) < 0.7


def test_the_bar_of_a_window_is_no_sure_road_of_a_map_either() -> None:
    surface = np.zeros((600, 900), np.float32)
    surface[:30] = 1.0
    cover = Cover(np.zeros(surface.shape, bool), np.zeros(surface.shape, np.float32), 30.0)
    assert _surest(roads_of_surface(surface, "map", cover=cover)) < 0.5
    surface[:, 400:430] = 1.0
    assert _surest(roads_of_surface(surface, "map", cover=cover)) > 0.9


def test_scattered_figures_are_no_sure_roads_and_a_few_are() -> None:
    rings = [(150, 150), (450, 150), (150, 450), (450, 450)]

    def drawn(count: int) -> np.ndarray:
        image = np.full((600, 900, 3), 255, np.uint8)
        for center in rings[:count]:
            cv2.circle(image, center, 90, (40, 40, 40), 7, cv2.LINE_AA)
        cv2.ellipse(image, (700, 300), (60, 150), 0, 0, 360, (40, 40, 40), 7, cv2.LINE_AA)
        return image

    assert _surest(roads_of_drawing(drawn(3))) < 0.5
    assert _surest(roads_of_drawing(drawn(2))) > 0.9


def test_a_map_that_hardly_a_road_leaves_was_drawn() -> None:
    """A house that stands on the ground."""
    surface = np.zeros((600, 900), np.float32)
    cv2.rectangle(surface, (250, 250), (650, 496), 1.0, 7)
    cv2.rectangle(surface, (350, 100), (550, 250), 1.0, 7)
    cv2.line(surface, (0, 500), (899, 500), 1.0, 7)
    cover = Cover(np.zeros(surface.shape, bool), np.zeros(surface.shape, np.float32), 7.0)
    assert _surest(roads_of_surface(surface, "map", cover=cover)) < 0.5
    cv2.line(surface, (450, 0), (450, 100), 1.0, 7)
    assert _surest(roads_of_surface(surface, "map", cover=cover)) > 0.9
