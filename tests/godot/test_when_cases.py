"""Conditions of `when:` mean in the engine what they mean in Python: one table of cases for both.

The engine's own tests run the same table (`godot_backend/tests/test_agents.gd`).
"""

from __future__ import annotations

import json
from typing import Any

import pytest

from roadlang import stl
from roadlang.diagnostics import DiagnosticError
from roadlang_godot.build.conditions import engine_formula
from roadlang_godot.engines import engine

TABLE = engine.project() / "tests" / "when_cases.json"
CASES = json.loads(TABLE.read_text(encoding="utf-8"))


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["formula"])
def test_python_agrees_with_the_table(case: Any) -> None:
    formula = stl.parse(case["formula"])
    signals = {**case["signals"], "time": case["time"]}
    assert engine_formula(formula, {name: [name] for name in signals}) == case["tree"]
    assert formula.truth(case["time"], signals).tolist() == case["truth"]


def test_the_table_has_every_operator_that_a_condition_may_have() -> None:
    text = " ".join(case["formula"] for case in CASES)
    assert all(word in text for word in ("once", "historically", "since", "iff", "xor", "min("))
    with pytest.raises(DiagnosticError, match="RL513"):
        engine_formula(stl.parse("eventually (x > 1)"), {"x": ["x"]})
