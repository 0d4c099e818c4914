"""How far roads can be apart by the passes in which they differ."""

from __future__ import annotations

import math

import numpy as np

from roadlang.ir.road_bounds import RoadBounds

SHARED = RoadBounds("shared", "main", {"main/1": 1.0})
LEFT = RoadBounds("left", "main", {"main/1": 1.0, "left/1": 2.0})
RIGHT = RoadBounds("right", "main", {"main/1": 1.0, "right/1": np.array([[4.0], [8.0]])})


def test_a_road_is_as_far_from_its_root_as_its_passes_together() -> None:
    assert RoadBounds("main", "main").displacement == 0.0
    assert LEFT.displacement == 3.0
    assert np.array_equal(RIGHT.displacement, [[5.0], [9.0]])


def test_passes_that_both_roads_have_do_not_part_them() -> None:
    assert LEFT.apart(LEFT) == 0.0
    assert (LEFT.apart(SHARED), SHARED.apart(LEFT)) == (2.0, 2.0)
    assert np.array_equal(LEFT.apart(RIGHT), [[6.0], [10.0]])


def test_of_roads_with_different_roots_nothing_is_known() -> None:
    assert LEFT.apart(RoadBounds("left", "side", {"left/1": 2.0})) == math.inf
