"""The verdict of one candidate: robustness, satisfaction, and where a formula is violated."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..evaluate.concrete import condition_json
from ..evaluate.evaluation import build
from ..ir.scenario import ScenarioConstraint
from ..ir.scene import Verdict
from ..ir.values import Condition, PassCall
from ..stl.evaluate.satisfaction import Truth, is_satisfied, zero_satisfies
from .road_conditions import condition_rho, condition_truth
from .road_monitors import monitor_rho
from .stated_ranges import check_stated_ranges
from .violations import violated_stretches


def verdict(constraint: ScenarioConstraint, candidates: CandidateBatch) -> Verdict:
    """A `require` or `expect` of the only candidate: judged over its roads and numbers; over a
    drive, with all that is needed to judge it by a trace."""
    test = constraint.test
    if isinstance(test, Condition):
        return _of_condition(constraint.name, test, candidates)
    entry, kind = candidates.scenario.kind(test)
    pending = Verdict(constraint.name, f"with {entry.name}", kind.domain, None, None)
    if kind.domain == "drive":
        formula = {"monitor": entry.qualified, "options": _options(test, candidates)}
        return replace(pending, formula=formula)
    return decided(pending, float(monitor_rho(test, candidates)[0]), zero_satisfies)


def _of_condition(name: str, condition: Condition, candidates: CandidateBatch) -> Verdict:
    pending = Verdict(name, condition.text, condition.domain, None, None)
    if condition.domain == "drive":
        return replace(pending, formula=condition_json(condition, candidates))
    check_stated_ranges(condition, candidates)
    rho = float(condition_rho(condition, candidates)[0])
    found = decided(pending, rho, lambda rows: condition_truth(condition, candidates))
    if found.satisfied or condition.domain != "road":
        return found
    return replace(found, violated=violated_stretches(condition, candidates))


def decided(pending: Verdict, rho: float, truth: Truth) -> Verdict:
    """A verdict with its robustness (None where that is infinite) and whether it is satisfied."""
    satisfied = bool(is_satisfied(np.array([rho]), truth)[0])
    # Adding 0 turns -0, which reads like a violation, into 0.
    shown = rho + 0.0 if math.isfinite(rho) else None
    return replace(pending, robustness=shown, satisfied=satisfied)


def _options(call: PassCall, candidates: CandidateBatch) -> dict[str, Any]:
    built = build(call, candidates, single=True)
    return {key: _plain(value) for key, value in vars(built.kind).items()}


def _plain(value: Any) -> Any:
    return value if isinstance(value, str | int | float | bool | list | tuple | dict) else None
