"""Verdicts on the `expect`s of a scene that are already certain while it is driven."""

from __future__ import annotations

from dataclasses import replace

from ..diagnostics import DiagnosticError
from ..ir.scene import Scene, Verdict
from ..ir.trace import Trace
from ..plugins.registry import Registry
from .drives import DriveCondition, judge


def judge_so_far(scene: Scene, trace: Trace, registry: Registry) -> tuple[Verdict, ...]:
    """The expectations with their robustness on what was driven so far. `satisfied` is None while
    what comes next may still decide: an `eventually` that has not come true, an `always` that has
    not failed, a monitor. Expectations that cannot be evaluated have no robustness."""
    judged = judge(scene, trace, registry)
    return tuple(
        replace(found, satisfied=_certain(found, trace, registry))
        if found.domain == "drive"
        else found
        for found in judged.verdicts
    )


def _certain(found: Verdict, trace: Trace, registry: Registry) -> bool | None:
    if found.formula is None or "monitor" in found.formula or found.robustness is None:
        return None
    condition = DriveCondition(found.formula, trace, registry)
    formula, time, semantics = condition.formula, trace.time, condition.evaluation.semantics
    try:
        of_members = {
            str(formula.verdict(time, values, semantics=semantics))
            for _, values in condition.choices()
        }
    except DiagnosticError:
        return None
    if "violated" in of_members:
        return False
    return True if of_members <= {"satisfied"} else None
