"""Bricks in a photo are no streets; a town with straight streets is one."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from roadlang_standard.extraction.doubts.upright_patterns import is_upright_pattern
from roadlang_standard.extraction.networks.found_network import FoundNetwork, FoundRoad
from roadlang_standard.extraction.photos.photo_confidence import calibrated

_COURSES, _BRICKS, _HIGH, _LONG = 5, 6, 60.0, 100.0


def _lines(turned: float = 0.0, bond: float = 0.5) -> list[FoundRoad]:
    """The joints of a wall, turned by so many radians; `bond`: by how much of a brick each course
    is moved against the one below it."""
    nodes: dict[tuple[float, float], int] = {}
    ways = np.array([(np.cos(turned), np.sin(turned)), (-np.sin(turned), np.cos(turned))])

    def road(*ends: tuple[float, float]) -> FoundRoad:
        start, end = (nodes.setdefault(place, len(nodes)) for place in ends)
        points = np.linspace(ends[0], ends[1], 40) @ ways
        sure = np.full(40, 0.9)
        return FoundRoad(start, end, points, np.full(40, 4.0), confidence=0.9, confidences=sure)

    roads = []
    for course in range(_COURSES):
        low, high = course * _HIGH, (course + 1) * _HIGH
        shift = bond * _LONG * (course % 2)
        columns = [shift + _LONG * brick for brick in range(1, _BRICKS)]
        roads += [road((x, low), (x, high)) for x in columns]
        if course:
            below = [bond * _LONG - shift + _LONG * brick for brick in range(1, _BRICKS)]
            along = sorted({0.0, *columns, *below, _LONG * (_BRICKS + 1)})
            roads += [road((a, low), (b, low)) for a, b in pairwise(along)]
    return roads


def test_bricks_are_a_pattern_and_crossing_streets_are_not() -> None:
    assert is_upright_pattern(_lines())
    assert not is_upright_pattern(_lines(bond=0.0))
    assert not is_upright_pattern([])


def test_streets_that_do_not_run_along_the_picture_are_no_pattern() -> None:
    assert not is_upright_pattern(_lines(turned=0.2))


def test_bricks_in_a_photo_are_no_sure_roads() -> None:
    def most(roads: list[FoundRoad]) -> float:
        network = FoundNetwork(np.zeros((90, 2)), tuple(roads), np.zeros((400, 800), bool))
        return max(road.confidence for road in calibrated(network, doubt_alone=True).roads)

    assert most(_lines()) < 0.5
    assert most(_lines(bond=0.0)) > 0.8
