"""Conditions of one form are found together."""

from __future__ import annotations

import json
from types import SimpleNamespace
from typing import Any

import pytest

from roadlang.simulation.signals import triggers


def test_a_formula_that_many_scenes_share_is_told_from_others_once(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    written: list[Any] = []

    def dumps(value: Any, **more: Any) -> str:
        written.append(value)
        return json.dumps(value, **more)

    monkeypatch.setattr(triggers, "json", SimpleNamespace(dumps=dumps))
    slow, equal, fast = {"<": ["v", 3]}, {"<": ["v", 3]}, {">": ["v", "least"]}
    signals = {"v": {"kind": "speed", "options": {"agent": "ego"}}}
    placed: list[triggers.PlacedCondition] = [
        (0, row, {"formula": formula, "signals": signals, "numbers": {"least": float(row)}})
        for row, formula in enumerate([slow] * 5 + [equal, fast, fast])
    ]
    forms = triggers.conditions_by_form(placed)
    assert [[row for _, row, _ in form] for form in forms] == [[0, 1, 2, 3, 4, 5], [6, 7]]
    assert len(written) == 3
