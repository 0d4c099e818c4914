"""Kinds made before anything is drawn: from constant options, or the ends of their ranges."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..diagnostics import DiagnosticError
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.values import PassCall
from ..plugins.guard import plugin_guard
from ..plugins.stated_bounds import OptionRange, corners, inner_points


def constant_kind(call: PassCall, scenario: IndexedScenario) -> Any:
    """A kind with its options, where all of them are constant and it takes them; None elsewhere."""
    combinations = option_corners(call, scenario)
    if combinations is None or len(combinations) != 1:
        return None
    try:
        return kind_at(combinations[0], call, scenario)
    except DiagnosticError:
        return None  # `refused_options` reports it


def option_corners(call: PassCall, scenario: IndexedScenario) -> list[dict[str, Any]] | None:
    """Every combination of the ends that options have; None where one is not known."""
    return corners(scenario.kind(call)[1], _ranges(call, scenario))


def inner_options(call: PassCall, scenario: IndexedScenario) -> list[dict[str, Any]]:
    """Options between their ends, where `option_corners` knows these."""
    return inner_points(scenario.kind(call)[1], _ranges(call, scenario))


def _ranges(call: PassCall, scenario: IndexedScenario) -> dict[str, Any]:
    """Each option as a range, or as it is where it is constant."""
    bounds = scenario.value_bounds
    calls = {name: _constant_calls(value, scenario) for name, value in call.options.items()}
    return {
        name: calls[name] if calls[name] is not None else bounds.option(value)
        for name, value in call.options.items()
    }


def kind_at(options: Mapping[str, Any], call: PassCall, scenario: IndexedScenario) -> Any:
    """The kind with these options. Raises what it refuses them with."""
    entry, kind = scenario.kind(call)
    with plugin_guard(entry, call.span, call.option_spans):
        return kind(**options)


def _constant_calls(value: Any, scenario: IndexedScenario) -> Any:
    """A list of calls as a tuple of kinds; None for anything else."""
    items = getattr(value, "items", ())
    if not items or not all(isinstance(item, PassCall) for item in items):
        return None
    kinds = tuple(constant_kind(item, scenario) for item in items)
    return kinds if None not in kinds else OptionRange(float("-inf"), float("inf"))
