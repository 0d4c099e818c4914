"""Formulas that cannot be evaluated on a closed road."""

from __future__ import annotations

from ...diagnostics import Code, Diagnostic, diagnose
from ...ir.values import Condition


def closed_road_fault(condition: Condition) -> Diagnostic | None:
    """RL312 for a formula over a closed road, where it looks between samples."""
    semantics = condition.evaluation.semantics
    if semantics == "sampled":
        return None
    return diagnose(Code.CLOSED_BETWEEN_SAMPLES, condition.semantics_span, semantics=semantics)
