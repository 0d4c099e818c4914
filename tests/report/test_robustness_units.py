"""The unit in which the robustness of an expectation is shown."""

from __future__ import annotations

import pytest

from roadlang.ir.scene import Verdict
from roadlang.report.numbers import quantity
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


@pytest.mark.parametrize(
    ("speed", "unit"),
    [
        ("ego.speed", "m/s"),
        ({"-": ["ego.speed", 2.0]}, "m/s"),
        ({"*": ["ego.speed", 2.0]}, ""),
        ({"-": [3.0, {"^": ["ego.speed", 2.0]}]}, ""),
    ],
)
def test_products_and_powers_have_another_unit(speed: object, unit: str) -> None:
    formula = {"formula": {"always": {"<": [speed, 4.0]}}, "signals": SPEED, "numbers": {}}
    verdict = Verdict("slow", "always ...", "drive", None, None, formula=formula)
    assert robustness_unit(verdict, installed()) == unit


def test_quantities_are_written_with_the_unit_that_people_read() -> None:
    assert quantity(None, "m") == "\N{EN DASH}"
    assert quantity(0.5, "rad") == "28.6\N{NO-BREAK SPACE}deg"
    assert quantity(-1.25, "m/s^2") == "\N{MINUS SIGN}1.25\N{NO-BREAK SPACE}m/s\N{SUPERSCRIPT TWO}"
