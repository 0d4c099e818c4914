"""Scenes that are far more alike than even draws would be are reported, unless they are few."""

from __future__ import annotations

from dataclasses import replace

import pytest

import roadlang
from roadlang.session.scene_set import SceneSet

LOADED = roadlang.loads(
    "road main { draw with waypoints { points: [(0m, 0m), (90m, 0m)] } }\n"
    "agent ego is car on main at 10m..50m\n"
)
SCENES = LOADED.sample(10, seed=1)


@pytest.mark.parametrize(
    ("found", "expected", "scenes", "reported"),
    [
        (0.05, 0.5, 10, True),
        (0.149, 0.5, 10, True),
        (0.151, 0.5, 10, False),
        (0.6, 0.5, 10, False),
        (0.05, 0.5, 9, False),
        (None, 0.5, 10, False),
        (0.05, None, 10, False),
    ],
)
def test_less_than_three_tenths_of_the_expected_diversity_is_reported(
    found: float | None, expected: float | None, scenes: int, reported: bool
) -> None:
    result = replace(
        SCENES.result,
        scenes=SCENES.result.scenes[:scenes],
        diversity=found,
        expected_diversity=expected,
    )
    said = SceneSet(LOADED, 1, result).diagnostics
    assert [diagnostic.code for diagnostic in said] == ["RL603"] * reported
