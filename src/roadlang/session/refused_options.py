"""Kinds that refuse their options, whatever is drawn."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ..diagnostics import Diagnostic, DiagnosticError
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.values import PassCall
from .constant_kinds import inner_options, kind_at, option_corners


def refused_options(scenario: IndexedScenario) -> Iterator[Diagnostic]:
    """What kinds raise as they are made, such as RL476 and RL480; each place once."""
    for call in scenario.calls():
        kind: Any = scenario.kind(call)[1]
        if hasattr(kind, "__post_init__"):
            yield from _refusal(call, scenario)


def _refusal(call: PassCall, scenario: IndexedScenario) -> tuple[Diagnostic, ...]:
    """What a kind raises at every corner of the ranges that its options have, and at points between
    them, as it may refuse the ends alone; else nothing."""
    refusal: tuple[Diagnostic, ...] = ()
    corners = option_corners(call, scenario) or []
    inside = inner_options(call, scenario) if len(corners) > 1 else []
    for options in (*corners, *inside):
        try:
            kind_at(options, call, scenario)
        except DiagnosticError as error:
            refusal = refusal or error.diagnostics
        else:
            return ()
    return refusal
