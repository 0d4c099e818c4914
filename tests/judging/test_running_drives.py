"""What is said of expectations while the drive goes on: only what nothing can change any more."""

from __future__ import annotations

import numpy as np
import pytest

import roadlang
from roadlang.ir.trace import Trace
from roadlang.judging.running_drives import judge_so_far

SCENE = """road main {{ draw with waypoints {{ points: [(0m, 0m), (80m, 0m)] }} }}
agent ego is car on main at 5m {{ drive with pure_pursuit {{ speed: 8m/s }} }}
expect it: {formula}
"""


@pytest.mark.parametrize(
    ("formula", "certain"),
    [
        ("eventually (ego.x > 1000m)", None),
        ("eventually (ego.x > 10m)", True),
        ("eventually[0s, 1s] (ego.x > 1000m)", False),
        ("always (ego.x < 1000m)", None),
        ("always (ego.x < 10m)", False),
        ("always[0s, 1s] (ego.x < 1000m)", True),
    ],
)
def test_an_expectation_is_undecided_until_nothing_can_change_it(
    formula: str, certain: bool | None
) -> None:
    loaded = roadlang.loads(SCENE.format(formula=formula))
    scenes = loaded.sample()
    driven: Trace = scenes.run(duration=4.0)[0].trace
    assert np.ptp(driven.agents["ego"].x) > 10.0
    (found,) = judge_so_far(scenes[0].record, driven, loaded.registry)
    assert found.satisfied is certain
    assert found.robustness is not None
