"""How many candidates a requirement was tried on, rejected, and how near the best came."""

from __future__ import annotations

import math

import numpy as np
import pytest

from roadlang.judging.acceptance import ACCEPTED, AcceptanceResult
from roadlang.judging.requirement import Requirement
from roadlang.search.rejection_report import RejectionStats, rows_of

NONE = math.nan
RESULT = AcceptanceResult(
    rejected_by=np.array([ACCEPTED, 0, 1, 0, ACCEPTED, 1]),
    rho=np.array([[1.0, -2.0, 0.5, -0.5, NONE, 0.2], [0.3, NONE, -4.0, NONE, 0.1, NONE]]),
    settled=np.array([[False, False, False, False, True, False], [False] * 6]),
)
FIRST = np.array([True] * 5 + [False])


def counted(*rows: np.ndarray) -> RejectionStats:
    stats = RejectionStats.empty(2)
    for part in rows:
        stats.count(RESULT, part)
    return stats


def test_what_bounds_decide_counts_as_tried() -> None:
    first, both = counted(FIRST), counted(FIRST, ~FIRST)
    assert (first.candidates, first.tried, first.rejected) == (5, [5, 3], [2, 1])
    assert (both.candidates, both.tried, both.rejected) == (6, [6, 4], [2, 2])
    assert both.settled == [1, 0]


def test_the_best_is_the_greatest_of_all_batches() -> None:
    assert counted(FIRST, ~FIRST).best == counted(~FIRST, FIRST).best == [1.0, 0.3]
    assert counted(~FIRST).best == [0.2, -math.inf]
    stats = counted(~FIRST)
    stats.see(0, 0.1)
    stats.see(1, -3.0)
    assert stats.best == [0.2, -3.0]


@pytest.mark.parametrize("share", [None, 0.25])
def test_parts_add_up_in_any_order(share: float | None) -> None:
    one, other, whole = counted(FIRST), counted(~FIRST), counted(FIRST | True)
    whole.even_share = other.even_share = share
    one.add(other)
    assert one == whole


def requirement(name: str, implied: bool = False) -> Requirement:
    def nothing(candidates: object) -> np.ndarray:
        raise AssertionError

    return Requirement(name, f"{name} > 0", nothing, 1.0, frozenset(), True, implied=implied)


def test_rows_are_those_that_reject_most_first_with_their_share() -> None:
    near, fits = rows_of(counted(FIRST), [requirement("near"), requirement("fits")], frozenset([1]))
    assert (near.name, near.text, near.tried, near.rejected) == ("near", "near > 0", 5, 2)
    assert (near.share, near.best, near.settled) == (0.4, 1.0, 1)
    assert (fits.tried, fits.rejected, fits.best) == (3, 1, 0.3)
    assert fits.share == pytest.approx(1 / 3)
    assert (near.impossible, fits.impossible) == (False, True)
    stats = RejectionStats(0, [4, 4, 0], [1, 3, 0], [0, 2, 0], [0.0, -1.0, -math.inf])
    first, second, third = rows_of(stats, [requirement(name) for name in "abc"], frozenset())
    assert [row.name for row in (first, second, third)] == ["b", "a", "c"]
    assert first.best is None, "others were accepted by bounds alone: it may be greater"
    assert (second.best, third.best, third.share) == (0.0, None, 0.0)


def test_what_is_implied_has_a_row_only_where_it_rejects() -> None:
    implied = [requirement("near", implied=True), requirement("fits", implied=True)]
    assert [row.name for row in rows_of(counted(~FIRST), implied, frozenset())] == ["fits"]
