"""What candidates have drawn keeps the order in which it was drawn."""

from __future__ import annotations

import numpy as np

from roadlang.evaluate.draw_record import DrawRecord

NAMES = [f"road{number}/perturb 1/amplitude" for number in range(20)]
"""More than a set would have in order by chance"""


def test_what_single_candidates_drew_is_added_in_its_order() -> None:
    alone = DrawRecord({name: np.array([0.5]) for name in NAMES})
    record = DrawRecord()
    record.add_alone({1: alone}, 3)
    assert list(record.coordinates) == NAMES
    assert list(record.absent) == NAMES


def test_what_some_candidates_lack_is_taken_in_its_order() -> None:
    lacking = {name: np.array([True, False, False]) for name in NAMES}
    record = DrawRecord({name: np.zeros(3) for name in NAMES}, absent=lacking)
    assert list(record.take(np.array([0, 1]), 3).absent) == NAMES


def test_draws_that_no_taken_candidate_has_are_gone_and_full_ones_are_not_absent() -> None:
    lacking = {
        "never": np.array([True, True, False]),
        "partly": np.array([True, False, False]),
        "always": np.array([False, False, True]),
    }
    taken = DrawRecord({name: np.arange(3.0) for name in lacking}, absent=lacking).take(
        np.array([0, 1]), 3
    )
    assert list(taken.coordinates) == ["partly", "always"]
    assert {name: lacks.tolist() for name, lacks in taken.absent.items()} == {
        "partly": [True, False]
    }
