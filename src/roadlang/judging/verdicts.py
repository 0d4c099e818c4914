"""Verdicts of candidates: robustness, satisfaction, and where a formula is violated."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..evaluate.concrete import condition_json
from ..evaluate.evaluation import build
from ..geometry.arrays import Floats
from ..ir.scenario import ScenarioConstraint
from ..ir.scene import Verdict, ViolatedSegment
from ..ir.values import Condition, PassCall
from ..stl.evaluate.satisfaction import Truth, is_satisfied, zero_satisfies
from .road_conditions import condition_rho, condition_truth
from .road_monitors import monitor_rho
from .stated_ranges import check_stated_ranges
from .violations import violated_stretches


def verdict(constraint: ScenarioConstraint, candidates: CandidateBatch) -> Verdict:
    """As `verdicts`, of a single candidate."""
    return verdicts(constraint, candidates)[0]


def verdicts(constraint: ScenarioConstraint, candidates: CandidateBatch) -> list[Verdict]:
    """A `require` or `expect` of each candidate: judged over its roads and numbers; over a drive,
    with all that is needed to judge it by a trace, and then of a single candidate."""
    test = constraint.test
    if isinstance(test, Condition):
        return _of_condition(constraint.name, test, candidates)
    entry, kind = candidates.scenario.kind(test)
    pending = Verdict(constraint.name, f"with {entry.name}", kind.domain, None, None)
    if kind.domain == "drive":
        formula = {"monitor": entry.qualified, "options": _options(test, candidates)}
        return [replace(pending, formula=formula)]
    return _decided_each(pending, monitor_rho(test, candidates), zero_satisfies)


def _of_condition(name: str, condition: Condition, candidates: CandidateBatch) -> list[Verdict]:
    pending = Verdict(name, condition.text, condition.domain, None, None)
    if condition.domain == "drive":
        return [replace(pending, formula=condition_json(condition, candidates))]
    check_stated_ranges(condition, candidates)
    rho = condition_rho(condition, candidates)
    found = _decided_each(pending, rho, lambda rows: condition_truth(condition, candidates)[rows])
    if condition.domain != "road":
        return found
    return [
        each if each.satisfied else replace(each, violated=_violated(condition, candidates, row))
        for row, each in enumerate(found)
    ]


def _violated(
    condition: Condition, candidates: CandidateBatch, row: int
) -> tuple[ViolatedSegment, ...]:
    single = candidates if candidates.count == 1 else candidates.take(np.array([row]))
    return violated_stretches(condition, single)


def decided(pending: Verdict, rho: float, truth: Truth) -> Verdict:
    """A verdict with its robustness (None where that is infinite) and whether it is satisfied."""
    ((shown, satisfied),) = _shown(np.array([rho]), truth)
    return replace(pending, robustness=shown, satisfied=satisfied)


def _decided_each(pending: Verdict, rho: Floats, truth: Truth) -> list[Verdict]:
    name, text, domain = pending.name, pending.text, pending.domain
    return [Verdict(name, text, domain, *outcome) for outcome in _shown(rho, truth)]


def _shown(rho: Floats, truth: Truth) -> list[tuple[float | None, bool]]:
    """(V) robustness as scenes have it, and whether it satisfies."""
    satisfied: list[bool] = is_satisfied(rho, truth).tolist()
    # Adding 0 turns -0, which reads like a violation, into 0.
    shown = [value + 0.0 if math.isfinite(value) else None for value in rho.tolist()]
    return list(zip(shown, satisfied, strict=True))


def _options(call: PassCall, candidates: CandidateBatch) -> dict[str, Any]:
    built = build(call, candidates, single=True, resolve=lambda entity: entity.text)
    return {key: _plain(value) for key, value in vars(built.kind).items()}


def _plain(value: Any) -> Any:
    return value if isinstance(value, str | int | float | bool | list | tuple | dict) else None
