"""What a pilot counts and scores, by itself."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from roadlang.judging.acceptance import Measurements
from roadlang.search.guiding import _Climb, _count, _scale, _some
from roadlang.search.rejection_report import RejectionStats

NAN, INF = math.nan, math.inf
MEASURED = Measurements(
    np.array([[2.0, -1.0, -3.0, INF, -INF], [1.0, 5.0, -4.0, NAN, 0.0]]),
    np.array([[True, False, False, True, False], [True, True, False, False, True]]),
)


@pytest.mark.parametrize(
    ("count", "most", "chosen"),
    [
        (0, 3, []), (2, 3, [0, 1]), (3, 3, [0, 1, 2]), (4, 3, [0, 1, 2]), (7, 3, [0, 2, 4]),
        (100, 4, [0, 25, 50, 75]),
    ],
)  # fmt: skip
def test_some_of_many_are_evenly_spread(count: int, most: int, chosen: list[int]) -> None:
    assert _some(count, most).tolist() == chosen


def test_the_usual_violation_is_the_mean_of_those_that_are_finite() -> None:
    """1 where a requirement is never violated."""
    rho = np.array([[2.0, -1.0, -3.0, INF, -INF], [1.0, 0.0, NAN, 5.0, INF], [-0.5, 1, 1, 1, 1]])
    assert _scale(rho).tolist() == [[2.0], [1.0], [0.5]]


def test_the_first_requirement_that_fails_rejects() -> None:
    stats = RejectionStats.empty(2)
    for total in (1, 2):
        _count(stats, MEASURED)
        assert stats.candidates == 5 * total
        assert stats.tried == [5 * total, 2 * total]
        assert stats.rejected == [3 * total, total]
        assert stats.best == [2.0, 5.0]


def climb(**members: Any) -> _Climb:
    found = object.__new__(_Climb)
    vars(found).update(members)
    return found


def test_a_score_is_how_far_a_candidate_is_from_holding() -> None:
    """In usual violations, of all that is violated; at most 9 of each requirement."""
    scale = np.array([[2.0], [0.1]])
    scores, holds = climb(stats=RejectionStats.empty(2), scale=scale)._scored(MEASURED)
    assert holds.tolist() == [True, False, False, False, False]
    assert scores.tolist() == pytest.approx([0.0, -0.5, -1.5 - 9.0, -1e-12, -4.5])


@pytest.mark.parametrize(
    ("scores", "bar"),
    [
        (np.arange(100.0), 65.0),  # the 35 best of 100
        (np.arange(3.0), 0.0),  # all of a few
    ],
)
def test_a_level_keeps_the_better_third_of_a_region(scores: np.ndarray, bar: float) -> None:
    others = np.full(50, 1e6)
    members = np.arange(len(scores) + 50) < len(scores)
    assert climb(scores=np.concatenate([scores[::-1], others]))._bar(members) == bar


@pytest.mark.parametrize(
    ("near", "far", "settled"),
    [(127, None, False), (128, None, True), (128, 0, False), (100, 27, False), (107, 21, False),
     (106, 22, True)],
)  # fmt: skip
def test_a_pilot_ends_with_enough_points_that_hold_in_every_region(
    near: int, far: int | None, settled: bool
) -> None:
    """128 in all, and in no region less than a third of its part."""
    rng = np.random.default_rng(3)
    parts = [0.1 + 0.01 * rng.random((150, 2))]
    holds = [np.arange(150) < near]
    if far is not None:
        parts.append(0.9 + 0.01 * rng.random((150, 2)))
        holds.append(np.arange(150) < far)
    found = climb(points=np.concatenate(parts), holds=np.concatenate(holds))
    assert found.is_settled() is settled
