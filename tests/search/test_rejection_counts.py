"""How many candidates a requirement was tried on, rejected, and how near the best came."""

from __future__ import annotations

import math

import numpy as np
import pytest

from roadlang.judging.acceptance import ACCEPTED, AcceptanceResult
from roadlang.search.rejection_report import RejectionStats

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
