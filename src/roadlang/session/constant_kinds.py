"""Kinds whose options are all constant, made before anything is drawn."""

from __future__ import annotations

from typing import Any

from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.values import PassCall
from ..plugins.guard import plugin_guard
from ..plugins.stated_bounds import OptionRange, corners


def constant_kind(call: PassCall, scenario: IndexedScenario) -> Any:
    """A kind with its options, where all of them are constant; None elsewhere."""
    entry, kind = scenario.kind(call)
    bounds = scenario.value_bounds
    calls = {name: _constant_calls(value, scenario) for name, value in call.options.items()}
    options = {
        name: calls[name] if calls[name] is not None else bounds.option(value)
        for name, value in call.options.items()
    }
    combinations = corners(kind, options)
    if combinations is None or len(combinations) != 1:
        return None
    with plugin_guard(entry, call.span):
        return kind(**combinations[0])


def _constant_calls(value: Any, scenario: IndexedScenario) -> Any:
    """A list of calls as a tuple of kinds; None for anything else."""
    items = getattr(value, "items", ())
    if not items or not all(isinstance(item, PassCall) for item in items):
        return None
    kinds = tuple(constant_kind(item, scenario) for item in items)
    return kinds if None not in kinds else OptionRange(float("-inf"), float("inf"))
