"""Which conditions the engine evaluates itself, and how they are sent to it."""

from __future__ import annotations

from typing import Any

import pytest

from roadlang import stl
from roadlang.diagnostics import DiagnosticError
from roadlang_godot.build.conditions import FOREVER, engine_formula, is_known

SENT: dict[str, Any] = {
    "x < 3": ["<", "x", 3.0],
    "x < 3 and y > 1": ["and", ["<", "x", 3.0], [">", "y", 1.0]],
    "x < 3 or y > 1": ["or", ["<", "x", 3.0], [">", "y", 1.0]],
    "not (x < 3)": [">=", "x", 3.0],
    "not once (x < 3)": ["all", 0.0, FOREVER, [">=", "x", 3.0]],
    "x + 2 * y < -abs(x)": ["<", ["+", "x", ["*", 2.0, "y"]], ["negate", ["abs", "x"]]],
    "x < 3 implies y > 1": ["or", [">=", "x", 3.0], [">", "y", 1.0]],
    "once[1, 2] (x < 3)": ["any", 1.0, 2.0, ["<", "x", 3.0]],
    "historically (x < 3)": ["all", 0.0, FOREVER, ["<", "x", 3.0]],
    "historically[1, inf] (x < 3)": ["all", 1.0, FOREVER, ["<", "x", 3.0]],
    "(x < 3) since[0, 4] (y > 1)": ["since", 0.0, 4.0, ["<", "x", 3.0], [">", "y", 1.0]],
    "true": True,
}


@pytest.mark.parametrize("text", SENT)
def test_conditions_are_sent_as_nested_lists(text: str) -> None:
    assert engine_formula(stl.parse(text), {"x": "x", "y": "y"}) == SENT[text]


@pytest.mark.parametrize("text", ["eventually (x < 3)", "(x < 3) until (y > 1)", "always (x < 3)"])
def test_what_looks_ahead_is_refused(text: str) -> None:
    with pytest.raises(DiagnosticError, match="RL513"):
        engine_formula(stl.parse(text), {"x": "x", "y": "y"})
    assert not is_known(condition(text, "speed"))


def condition(text: str, kind: str) -> dict[str, Any]:
    signals = {"x": {"kind": kind, "options": {}}}
    return {"formula": stl.to_json(stl.parse(text)), "signals": signals, "numbers": {"y": 3.0}}


@pytest.mark.parametrize(
    ("kind", "known"),
    [("speed", True), ("standard.gap", True), ("time_headway", False), ("acme.wind", False)],
)
def test_the_engine_knows_the_signals_that_it_measures(kind: str, known: bool) -> None:
    assert is_known(condition("once (x > y)", kind)) == known
