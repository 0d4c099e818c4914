"""The unit in which the robustness of an expectation is shown."""

from __future__ import annotations

import pytest

from roadlang.ir.scene import Verdict
from roadlang.report.units import robustness_unit
from roadlang.session.scene import installed

SPEED = {"ego.speed": {"kind": "speed", "options": {"agent": "ego"}}}


@pytest.mark.parametrize(
    ("evaluation", "unit"),
    [
        ({}, "m/s"),
        ({"robustness": "average"}, "m/s"),
        ({"robustness": "time"}, "s"),
        ({"robustness": "time_left"}, "s"),
    ],
)
def test_a_shift_in_time_is_in_seconds(evaluation: dict[str, str], unit: str) -> None:
    formula = {
        "formula": {"always": {"<": ["ego.speed", 4.0]}},
        "signals": SPEED,
        "numbers": {},
        "evaluation": evaluation,
    }
    verdict = Verdict("slow", "always ego.speed < 4m/s", "drive", None, None, formula=formula)
    assert robustness_unit(verdict, installed()) == unit
