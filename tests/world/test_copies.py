"""The copies of groups: placed all at once, each as it would be by itself."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields

import numpy as np
import pytest

from roadlang.evaluate.candidates import CandidateBatch
from roadlang.ir.placed_batch import PlacedBatch
from roadlang.judging.acceptance import Acceptance
from roadlang.world.copies import counts
from roadlang.world.placement import placed
from tests.straight_road import STRAIGHT

BENT = (
    STRAIGHT.replace("road main", "road first")
    + "road main from first { perturb with sine { amplitude: 0m..6m, wavelength: 60m..90m } }\n"
)
GROUPS = (
    "param far = 1m..4m\n"
    "object things is choice(tree(length: 1m..3m), box) on main at 0%..100% {\n"
    '  count: integer(0, 4), side: choice("left", "right"), offset: far, heading: -9deg..9deg\n}\n'
    "object after is box on main at things.start / 2 { count: integer(0, 3), offset: 0m..far }\n"
    "object rocks is rock at (0m..9m, 20m..40m) { count: 3, heading: 0deg..360deg }\n"
)


@pytest.mark.parametrize("road", [STRAIGHT, BENT])
@pytest.mark.parametrize("name", ["things", "rocks"])
def test_a_candidate_among_many_is_placed_as_alone(
    acceptance: Callable[[str], Acceptance], road: str, name: str
) -> None:
    scenario = acceptance(road + GROUPS).scenario
    actor = scenario.actors[name]
    batch = CandidateBatch(scenario, 0, np.zeros(20, np.int64), np.arange(20))
    together = placed(actor, batch)
    for row in range(20):
        one = CandidateBatch(scenario, 0, np.zeros(1, np.int64), np.array([row]))
        number = int(counts(actor, one)[0])
        assert number == together.present[row].sum()
        for field in fields(PlacedBatch):
            alone = getattr(placed(actor, one), field.name)[0]
            np.testing.assert_array_equal(alone, getattr(together, field.name)[row, :number])


def test_survivors_keep_their_own_places(acceptance: Callable[[str], Acceptance]) -> None:
    scenario = acceptance(BENT + GROUPS).scenario
    batch = CandidateBatch(scenario, 0, np.zeros(9, np.int64), np.arange(9))
    before = placed(scenario.actors["things"], batch)
    after = placed(scenario.actors["things"], batch.take(np.array([7, 2, 2])))
    assert after.x.tolist() == before.x[[7, 2, 2]].tolist()
