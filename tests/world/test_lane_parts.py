"""Candidates whose roads have the same lanes are made together."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from roadlang.evaluate.candidates import CandidateBatch
from roadlang.judging.acceptance import Acceptance
from roadlang.world.roads.road_lanes import lane_parts, lanes_of
from tests.straight_road import STRAIGHT

COUNT = 30


def candidates(acceptance: Acceptance) -> CandidateBatch:
    return CandidateBatch(acceptance.scenario, 0, np.zeros(COUNT, np.int64), np.arange(COUNT))


@pytest.mark.parametrize(
    ("options", "parts"),
    [
        ("lanes: 2", 1),
        ("lanes: 2, width: 6m..8m", 1),
        ("lanes: integer(1, 3), width: 9m", 3),
        ("left: [drive], right: [drive, choice(parking, bike)]", COUNT),
    ],
)
def test_a_part_has_all_candidates_with_the_same_lanes(
    acceptance: Callable[[str], Acceptance], options: str, parts: int
) -> None:
    text = f"{STRAIGHT}road wide from main {{ {options} }}\n"
    batch = candidates(acceptance(text))
    found = lane_parts("wide", batch)
    assert len(found) == parts
    assert sorted(np.concatenate([rows for rows, _ in found]).tolist()) == list(range(COUNT))
    for rows, lanes in found:
        for row in rows.tolist():
            assert lanes_of("wide", batch.take(np.array([row]))).pattern.ids == lanes.pattern.ids
