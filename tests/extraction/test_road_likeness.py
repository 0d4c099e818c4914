"""How much lines are like roads by all that tells, where no single sign does."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from roadlang_standard.extraction.doubts.drawn_confidence import _are_stripes, with_doubts
from roadlang_standard.extraction.doubts.road_likeness import (
    LIKENESS,
    MAP_LIKENESS,
    likeness_facts,
    map_facts,
)
from roadlang_standard.extraction.networks.found_network import FoundNetwork, FoundRoad

_SHAPE = (600, 800)
_STAR = ((400, 300, 799, 300), (400, 300, 400, 0), (400, 300, 0, 300), (400, 300, 400, 599))


def _line(start: int, end: int, ends: tuple[int, int, int, int], width: float = 4.0) -> FoundRoad:
    points = np.linspace(ends[:2], ends[2:], 120).astype(float)
    return FoundRoad(start, end, points, np.full(120, width))


def _network(*roads: FoundRoad, method: str = "") -> FoundNetwork:
    return FoundNetwork(np.zeros((40, 2)), roads, np.zeros(_SHAPE, bool), method)


def _most(*roads: FoundRoad, drawn: bool = True, method: str = "") -> float:
    found = with_doubts(_network(*roads, method=method), drawn)
    return max(road.confidence for road in found.roads)


def _tree(below: int = 520, width: float = 2.0, thinner: float = 1.0) -> list[FoundRoad]:
    """Four computers, each with three lines, maybe thinner ones, to its own and one to the server
    above all."""
    lines = []
    top = 80
    for index, x in enumerate((130, 310, 490, 670)):
        lines.append(_line(0, index + 1, (400, top, x, 300), width))
        for leaf in range(3):
            at = x + 60 * (leaf - 1)
            lines.append(
                _line(index + 1, 5 + 3 * index + leaf, (x, 300, at, below), thinner * width)
            )
    return lines


def test_a_diagram_in_colors_is_no_sure_road_and_a_town_with_its_shape_is() -> None:
    diagram = [
        replace(road, widths=road.widths * (1 + 0.1 * np.resize((1, -1), len(road.widths))))
        for road in _tree(thinner=0.6)
    ]
    assert _most(*diagram, drawn=False) < 0.5
    assert _most(*_tree(width=4.0), drawn=True) > 0.9
    assert _most(*_tree(below=598, width=14.0), drawn=False) > 0.9


def test_what_somebody_said_to_be_roads_is_not_judged() -> None:
    assert _most(*_tree(), drawn=False, method="legend") == 1.0


def test_each_sign_is_what_it_says() -> None:
    facts = likeness_facts(_network(*_tree()), colored=True)
    assert list(facts) == list(LIKENESS)
    assert facts["always"] == 1.0
    assert facts["crossings"] == pytest.approx(np.log1p(5))
    assert facts["joins"] == facts["exits"] == facts["tight"] == 0.0
    assert facts["unlike"] == pytest.approx(0.0)
    assert facts["straight"] == 1.0
    assert facts["parts"] == pytest.approx(np.log1p(1))
    assert facts["thin"] == pytest.approx(np.log(0.015 * 600 / 2.0))
    wavy = np.linspace(0, 20 * np.pi, 900)
    tight = FoundRoad(
        0, 1, np.column_stack([40 + 9 * wavy, 300 + 30 * np.sin(wavy)]), np.full(900, 12.0)
    )
    assert likeness_facts(_network(tight), colored=False)["tight"] > 0.3


def test_curves_sharp_forks_and_a_small_extent_are_signs() -> None:
    facts = likeness_facts(_network(*_tree()), colored=True)
    assert facts["winding"] == pytest.approx(0.0, abs=1e-6)
    assert facts["forks"] == pytest.approx(np.log1p(5))
    assert facts["extent"] == pytest.approx(440 / 600)
    angle = np.linspace(0, 2 * np.pi, 400)
    ring = np.column_stack([400 + 100 * np.cos(angle), 300 + 100 * np.sin(angle)])
    circle = likeness_facts(_network(FoundRoad(0, 0, ring, np.full(400, 8.0))), colored=False)
    assert circle["winding"] == pytest.approx(600 / 100, rel=0.05)
    assert circle["forks"] == 0.0
    cross = [_line(0, k, ends) for k, ends in enumerate(_STAR, 1)]
    assert likeness_facts(_network(*cross), colored=False)["forks"] == 0.0


def test_a_fork_is_sharp_where_roads_leave_it_and_not_in_a_bend() -> None:
    """What they do farther away does not matter."""
    along = np.arange(0.0, 300.0)
    beyond = np.maximum(0.0, along - 40.0)
    rises = (0.0, -4.0)
    first, second = (
        FoundRoad(0, number, np.column_stack([along, 300.0 + rise * beyond]), np.full(300, 4.0))
        for number, rise in enumerate(rises, 1)
    )
    back = _line(0, 3, (0, 300, 0, 599))
    assert likeness_facts(_network(first, second, back), colored=False)["forks"] > 0.0
    assert likeness_facts(_network(first, second), colored=False)["forks"] == 0.0


def test_stripes_are_no_sure_roads_and_few_parallel_streets_are() -> None:
    stripes = [_line(2 * k, 2 * k + 1, (60 * k, 0, 60 * k + 200, 599), 9.0) for k in range(8)]
    assert _most(*stripes) < 0.5
    assert _most(*stripes[:3]) > 0.9
    across = [_line(0, 1, (0, 300, 799, 300), 9.0)]
    assert _most(*across, *stripes[1:6]) > 0.9
    assert _most(*stripes, drawn=False) > 0.9  # of a map, whose streets go on


def test_stripes_are_straight_and_meet_no_other_line() -> None:
    along = np.arange(0.0, 500.0)
    for bent, are_stripes in ((3.0, True), (30.0, False)):
        y = [60.0 * k + bent * np.sin(along / 20) for k in range(8)]
        lines = [FoundRoad(0, 1, np.column_stack([along, one]), np.full(500, 4.0)) for one in y]
        assert _are_stripes([[line] for line in lines]) is are_stripes
        assert not _are_stripes([[line, line] for line in lines])


def test_a_parking_lot_says_nothing_about_the_width_of_roads() -> None:
    road, lot = _line(0, 1, (0, 300, 799, 300), 20.0), _line(2, 3, (300, 150, 420, 150), 110.0)
    assert likeness_facts(_network(road, lot), colored=False)["unlike"] < 0.01
    lane = _line(2, 3, (300, 150, 420, 150), 5.0)
    assert likeness_facts(_network(road, lane), colored=False)["unlike"] > 0.2


def test_rows_of_a_form_that_leave_a_picture_in_colors_are_no_sure_roads() -> None:
    rows = [_line(2 * i, 2 * i + 1, (0, 60 + 90 * i, 799, 60 + 90 * i), 34.0) for i in range(5)]
    assert _most(*rows, drawn=False) < 0.5


def test_streets_of_a_map_that_leave_it_are_sure() -> None:
    assert _most(*(_line(0, i + 1, ends, 8.0) for i, ends in enumerate(_STAR)), drawn=False) > 0.9
    turned = [_line(2 * i, 2 * i + 1, (0, 40 + 70 * i, 799, 130 + 90 * i), 7.0) for i in range(5)]
    assert _most(*turned, drawn=False) > 0.9


def test_each_sign_of_a_map_is_what_it_says() -> None:
    facts = map_facts(_network(*(_line(0, i + 1, ends, 6.0) for i, ends in enumerate(_STAR))))
    assert set(facts) == set(MAP_LIKENESS)
    assert facts["upright"] == pytest.approx(1.0)
    assert facts["odd"] == pytest.approx(0.0)
    assert facts["apart"] == pytest.approx(0.25)
    assert facts["many"] == pytest.approx(np.log(4))
    assert facts["sharp"] == 0.0


def test_a_screen_in_colors_that_no_road_leaves_is_no_map_either() -> None:
    corners = ((200, 100), (600, 100), (600, 500), (200, 500), (200, 100))
    points = np.concatenate(
        [np.linspace(a, b, 60, endpoint=False) for a, b in pairwise(corners)] + [[corners[-1]]]
    )
    frame = FoundRoad(0, 0, points.astype(float), np.full(len(points), 16.0))
    assert _most(frame, drawn=False) < 0.5
