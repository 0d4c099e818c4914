"""The copies of groups: placed all at once, each as it would be by itself."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields

import numpy as np
import pytest

from roadlang import testing
from roadlang.evaluate.candidates import CandidateBatch
from roadlang.evaluate.copies import CopyBatch
from roadlang.ir.placed_batch import PlacedBatch
from roadlang.judging.acceptance import Acceptance
from roadlang.world.placement.copies import counts, kinds_of_copies
from roadlang.world.placement.placement import placed
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


def test_numbers_of_copies_are_found_for_every_candidate() -> None:
    """Also where they are the same in all of them."""
    text = STRAIGHT + (
        "param gap = 5m..9m\n"
        "agent cars is car on main at 10m { count: 2, spacing: 20m }\n"
        "object cones is cone on main at cars.start + gap { count: 2 }\n"
        "object posts is cone on main at cars.start + 3m { count: 2, side: left }\n"
    )
    for scene in testing.sample(text, 4):
        starts = {thing.name: thing.start for thing in scene.record.objects}
        gap = scene.draws["gap"]
        assert starts["cones[0]"] == pytest.approx(10.0 + gap)
        assert starts["cones[1]"] == pytest.approx(30.0 + gap)
        assert (starts["posts[0]"], starts["posts[1]"]) == (13.0, 33.0)


def test_what_was_drawn_once_for_all_copies_is_told_of_groups_that_have_some() -> None:
    text = STRAIGHT + (
        "param far = 1m..4m\n"
        "object trees is tree on main at 20m..180m { count: integer(0, 1), offset: far }\n"
    )
    scenes = list(testing.sample(text, 30))
    assert {len(scene.record.objects) for scene in scenes} == {0, 1}
    for scene in scenes:
        told = [place for place in scene.draws if place.startswith("trees/at")]
        assert len(told) == len(scene.record.objects)


def test_copies_of_a_kind_without_drawn_options_share_it(
    acceptance: Callable[[str], Acceptance],
) -> None:
    scenario = acceptance(STRAIGHT + GROUPS).scenario
    candidates = CandidateBatch(scenario, 0, np.zeros(30, np.int64), np.arange(30))
    copies = CopyBatch.every(candidates, 2)
    found = kinds_of_copies(scenario.actors["things"], copies).instances
    boxes = {id(one) for one in found if one.kind.name == "box"}
    trees = [one for one in found if one.kind.name == "tree"]
    assert len(boxes) == 1
    assert len({id(one) for one in trees}) == len(trees) > 20
