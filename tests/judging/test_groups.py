"""Requirements on groups: each copy that a candidate has, and no other, must satisfy them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from roadlang.evaluate.candidates import CandidateBatch
from roadlang.judging.acceptance import Acceptance
from roadlang.world.placement.copies import counts
from roadlang.world.placement.placement import placed_copy
from tests.straight_road import STRAIGHT

TREES = (
    STRAIGHT + "object trees is tree on main at choice(10m, 30m) "
    "{ count: integer(0, 3), overlap: true }\n"
)


@pytest.mark.parametrize("limit", ["<= 10m", "< 10m", "<= 30m", "< 20m"])
def test_copies_that_a_candidate_does_not_have_are_left_out(
    acceptance: Callable[[str], Acceptance], limit: str
) -> None:
    """At a robustness of 0 as well, where the truth of each copy decides."""
    requirements = acceptance(TREES + f"require r: trees.start {limit}\n")
    index = next(i for i, found in enumerate(requirements.requirements) if found.name == "r")
    batch = CandidateBatch(requirements.scenario, 0, np.zeros(99, np.int64), np.arange(99))
    actor = requirements.scenario.actors["trees"]
    number = counts(actor, batch)
    starts = np.hstack([placed_copy(actor, batch, copy).start for copy in (1, 2, 3)])
    most = float(limit.split()[1].removesuffix("m"))
    holds = starts < most if limit.startswith("< ") else starts <= most
    expected = (holds | (np.arange(3) >= number[:, None])).all(axis=1)
    assert (requirements.measure(batch).satisfied[index] == expected).all()
    assert set(number) == {0, 1, 2, 3}
    assert (requirements.judge(batch).accepted == expected).all()
