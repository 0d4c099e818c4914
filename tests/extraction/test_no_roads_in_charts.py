"""Charts, forms and other diagrams: what is found in them is said to be doubtful."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.doubts import drawn_confidence
from roadlang_standard.extraction.doubts.drawn_confidence import with_doubts
from roadlang_standard.extraction.drawings.thresholding import ContourSteps, roads_by_contour
from roadlang_standard.extraction.networks.found_network import EDGE_LINES, FoundNetwork, FoundRoad


def _page() -> np.ndarray:
    return np.full((480, 640, 3), 255, np.uint8)


def _found(page: np.ndarray) -> FoundNetwork:
    return roads_by_contour(page, ContourSteps())


def _line(start: int, end: int, way: tuple[int, int, int, int], wide: float = 4) -> FoundRoad:
    x, y = np.linspace(*way[::2], 50), np.linspace(*way[1::2], 50)
    return FoundRoad(start, end, np.column_stack([x, y]), np.full(50, wide))


def _sure(*roads: FoundRoad, drawn: bool = True) -> list[float]:
    mask = np.zeros((100, 200), bool)
    return [road.confidence for road in with_doubts(_network(mask, *roads), drawn).roads]


def _network(mask: np.ndarray, *roads: FoundRoad) -> FoundNetwork:
    return FoundNetwork(np.zeros((20, 2)), roads, mask)


def _curve(page: np.ndarray) -> np.ndarray:
    x = np.linspace(110, 560, 200)
    wave = np.column_stack([x, 240 + 90 * np.sin(x / 60)]).astype(np.int32)
    cv2.polylines(page, [wave], False, (0, 0, 0), 2, cv2.LINE_AA)
    return page


def test_the_curve_of_a_chart_is_no_sure_road_but_the_same_one_without_axes_is() -> None:
    chart = _curve(_page())
    cv2.rectangle(chart, (90, 70), (580, 410), (0, 0, 0), 2)
    assert all(road.confidence < 0.5 for road in _found(chart).roads)
    assert min(road.confidence for road in _found(_curve(_page())).roads) > 0.9


def test_rows_of_level_lines_are_fields_or_columns() -> None:
    rows = [_line(2 * k, 2 * k + 1, (20, 20 + 25 * k, 180, 20 + 25 * k)) for k in range(3)]
    assert _sure(*rows) == [0.45, 0.45, 0.45]
    assert _sure(*rows[:2]) == [1.0, 1.0]
    leaving = [_line(2 * k, 2 * k + 1, (0, 20 + 25 * k, 199, 20 + 25 * k)) for k in range(3)]
    assert _sure(*leaving) == [1.0, 1.0, 1.0]
    oblique = _line(4, 5, (20, 70, 180, 95))
    assert _sure(*rows[:2], oblique) == [1.0, 1.0, 1.0]


@pytest.fixture
def like_a_map(monkeypatch: pytest.MonkeyPatch) -> None:
    """What these few lines are like as a map is not what is tested."""
    monkeypatch.setattr(drawn_confidence, "sure_like_map", lambda found: 1.0)


@pytest.mark.usefixtures("like_a_map")
def test_what_surrounds_all_that_is_drawn_is_the_ground() -> None:
    mask = np.ones((100, 200), bool)
    mask[20:80, 20:180] = False
    ring = np.array([(10, 10), (190, 10), (190, 90), (10, 90), (10, 10)], float)
    around = FoundRoad(0, 0, ring, np.full(5, 20.0))
    inner = _line(1, 2, (30, 50, 170, 50))
    for drawn, expected in ((True, [False, False]), (False, [False, True])):
        leaving = _line(3, 4, (100, 0, 100, 10), 2)
        found = with_doubts(_network(mask, around, inner, leaving), drawn)
        assert [road.confidence > 0.5 for road in found.roads][:2] == expected


@pytest.mark.usefixtures("like_a_map")
def test_a_map_that_hardly_a_road_leaves_is_judged_as_a_drawing() -> None:
    """Walls of a floor plan, in several colors."""
    steps = [(1, 0)] * 120 + [(0, 1)] * 60 + [(-1, 0)] * 120 + [(0, -1)] * 60
    walls = np.cumsum([(40, 20), *steps], axis=0).astype(float)
    room = FoundRoad(0, 0, walls, np.full(len(walls), 2.0))
    assert _sure(room, drawn=False) == [0.45]
    street, drive = _line(1, 2, (0, 90, 199, 90)), _line(3, 4, (180, 99, 180, 92))
    assert _sure(room, street, drawn=False)[0] < 0.5
    assert _sure(room, street, drive, drawn=False)[0] == 1.0


def test_between_edge_lines_a_road_is_even() -> None:
    mask = np.zeros((100, 200), bool)
    mask[40:60, 20:180] = True
    mask[30:70, 80:100] = True
    network = _network(mask, _line(0, 1, (20, 49, 180, 49), 20))
    assert [road.confidence for road in with_doubts(network).roads] == [1.0]
    edged = with_doubts(replace(network, method=EDGE_LINES))
    assert [0.2 < road.confidence < 0.8 for road in edged.roads] == [True]


def test_a_given_width_says_nothing_about_what_was_seen() -> None:
    mask = np.zeros((100, 200), bool)
    mask[30:70, 20:180] = True
    narrow = _network(mask, _line(0, 1, (20, 49, 180, 49), 10))
    assert [road.confidence for road in with_doubts(narrow).roads] == [0.0]
    assert [road.confidence for road in with_doubts(narrow, measured=False).roads] == [1.0]
