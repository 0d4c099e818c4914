"""The units of what a report shows."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..diagnostics import DiagnosticError
from ..ir.scene import Verdict
from ..plugins.finding import entry_of
from ..plugins.guard import plugin_guard
from ..plugins.kinds import DriveSignal
from ..plugins.registry import Registry
from ..stl.formats.evaluation_json import evaluation_from_json

_UNIT_OF_POSITIONS = {"drive": "s", "road": "m"}
_CHANGE_THE_UNIT = ("*", "/", "^")


def robustness_unit(verdict: Verdict, registry: Registry) -> str:
    """The unit of the robustness of an expectation: that of the positions where it is a shift along
    them; else that of its signals, where all have the same and are only added and compared; empty
    for any other."""
    formula = verdict.formula
    if not isinstance(formula, Mapping) or "signals" not in formula:
        return ""
    if evaluation_from_json(formula.get("evaluation", {})).is_shift:
        return _UNIT_OF_POSITIONS.get(verdict.domain, "")
    if _has_any(formula.get("formula"), _CHANGE_THE_UNIT):
        return ""
    units = {_unit(call, registry) for call in formula["signals"].values()}
    return units.pop() if len(units) == 1 else ""


def _unit(call: Mapping[str, Any], registry: Registry) -> str:
    try:
        entry = entry_of(registry, "drive_signal", str(call["kind"]))
        with plugin_guard(entry, None):
            kind = entry.load()
        return kind.unit if issubclass(kind, DriveSignal) else ""
    except DiagnosticError:  # a plugin that is not installed here
        return ""


def _has_any(value: Any, keys: tuple[str, ...]) -> bool:
    if isinstance(value, Mapping):
        return any(key in keys or _has_any(member, keys) for key, member in value.items())
    if isinstance(value, list | tuple):
        return any(_has_any(item, keys) for item in value)
    return False
