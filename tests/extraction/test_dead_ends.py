"""Dead ends that face each other: what a bridge between them counts."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang_standard.extraction.graphs.dead_ends import TRUST_ALIGNED, DeadEnd, facing


def end(node: int, x: float, y: float, degrees: float) -> DeadEnd:
    """A dead end at (x, y) that runs on in a direction."""
    ahead = np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
    return DeadEnd(node, np.array([x, y]), ahead, node, 1)


def places(ends: list[DeadEnd], distance: float) -> list[list[tuple[float, float]]]:
    return [[tuple(place) for place, _ in faced] for faced in facing(ends, distance)]


def test_ends_in_one_line_face_each_other() -> None:
    first, second = facing([end(1, 0, 0, 0), end(2, 20, 0, 180)], 50.0)
    assert [(place.tolist(), share) for place, share in first] == [([20.0, 0.0], TRUST_ALIGNED)]
    assert [(place.tolist(), share) for place, share in second] == [([0.0, 0.0], TRUST_ALIGNED)]


def test_ends_that_turn_to_each_other_count_less_than_those_in_line() -> None:
    ((_, share),), _ = facing([end(1, 0, 0, 35), end(2, 20, 0, 180)], 50.0)
    assert TRUST_ALIGNED < share < 1


@pytest.mark.parametrize("degrees", [0, 90])
def test_an_end_that_runs_elsewhere_is_not_faced(degrees: float) -> None:
    assert places([end(1, 0, 0, 0), end(2, 20, 0, degrees)], 50.0) == [[], []]


def test_ends_farther_apart_than_the_distance_do_not_face_each_other() -> None:
    """One at the distance itself does."""
    ends = [end(1, 0, 0, 0), end(2, 20, 0, 180)]
    assert places(ends, 20.0) == [[(20.0, 0.0)], [(0.0, 0.0)]]
    assert places(ends, 19.9) == [[], []]


def test_faced_ends_come_in_the_order_of_the_ends() -> None:
    others = [end(node, x, 0, 180) for node, x in ((2, 30), (3, 10), (4, 20))]
    assert places([end(1, 0, 0, 0), *others], 50.0)[0] == [(30.0, 0.0), (10.0, 0.0), (20.0, 0.0)]


def test_no_ends_face_none() -> None:
    assert list(facing([], 50.0)) == []
