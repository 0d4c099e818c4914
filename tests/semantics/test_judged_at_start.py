"""A formula over signals without a temporal operator is judged at the start: a warning says so."""

from __future__ import annotations

import pytest

from roadlang import testing

ROAD = "road main { draw with segments { pieces: [straight(200m)] }, lanes: 2 }\n"
EGO = "agent ego is car on main at 5m { drive with traffic }\n"
LEAD = "agent lead is car on main at 50m { drive with traffic }\n"
LET = "let slow = ego.speed < 15m/s\n"


@pytest.mark.parametrize(
    ("formula", "what"),
    [
        ("expect e: ego.speed < 15m/s", "drive"),
        ("expect e: slow", "drive"),
        ("expect e: slow and not (distance(ego, lead) > 5m)", "drive"),
        ("require e: abs(curvature(main)) < 0.1/m", "road"),
    ],
)
def test_a_formula_that_is_judged_at_the_start_only_is_a_warning(formula: str, what: str) -> None:
    diagnostics = testing.check(ROAD + EGO + LEAD + LET + formula)
    (found,) = [each for each in diagnostics if each.code != "RL190"]
    assert (found.code, found.severity) == ("RL295", "warning")
    assert f"the start of the {what} only" in found.message
    assert "write `always (" in found.help[0]


@pytest.mark.parametrize(
    "formula",
    [
        "expect e: always slow",
        "expect e: slow implies eventually (ego.speed > 1m/s)",
        "expect e: always[0s, 0s] slow",
        "require e: length(main) > 50m",
        "require e: lead.start - ego.start > 5m",
        "require e: distance(ego, lead) > 5m",
    ],
)
def test_formulas_with_an_operator_and_numbers_are_none(formula: str) -> None:
    assert "RL295" not in [d.code for d in testing.check(ROAD + EGO + LEAD + LET + formula)]
