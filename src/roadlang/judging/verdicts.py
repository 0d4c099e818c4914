"""The verdicts of one candidate: robustness and the stretches where a formula is violated."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..evaluate.concrete import condition_json
from ..evaluate.evaluation import build
from ..ir.scenario import Constraint
from ..ir.scene import Stretch, Verdict
from ..ir.values import Condition
from ..world.signals import axes_of
from .requirements import axis_signals, condition_rho, monitor_rho


def verdict(constraint: Constraint, candidates: CandidateBatch) -> Verdict:
    """A `require` or `expect` over roads, judged; over the drive, ready to be judged."""
    test = constraint.test
    if isinstance(test, Condition):
        return _of_condition(constraint.name, test, candidates)
    entry, kind = candidates.scenario.kind(test)
    domain: str = getattr(kind, "domain", "road")
    text = f"with {entry.name}"
    if domain == "drive":
        built = build(test, candidates, single=True)
        options = {key: _plain(value) for key, value in vars(built.kind).items()}
        formula = {"monitor": entry.qualified, "options": options}
        return Verdict(constraint.name, text, domain, None, None, formula=formula)
    rho = float(monitor_rho(test, candidates)[0])
    return Verdict(constraint.name, text, domain, _finite(rho), rho >= 0.0)


def _of_condition(name: str, condition: Condition, candidates: CandidateBatch) -> Verdict:
    if condition.domain == "drive":
        formula = condition_json(condition, candidates)
        return Verdict(name, condition.text, "drive", None, None, formula=formula)
    rho = float(condition_rho(condition, candidates)[0])
    satisfied = rho > 0.0 or (rho == 0.0 and holds_at_zero(condition, candidates))
    violated = () if satisfied or condition.domain != "road" else _violated(condition, candidates)
    return Verdict(name, condition.text, condition.domain, _finite(rho), satisfied, violated)


def holds_at_zero(condition: Condition, candidates: CandidateBatch) -> bool:
    """Whether a formula of robustness 0 is satisfied: `<=` is, `<` is not."""
    for axis in axes_of(condition, candidates):
        positions, values, wrap = axis_signals(condition, axis, 1, candidates)
        if not bool(np.all(condition.formula.satisfied(positions, values, wrap=wrap))):
            return False
    return True


def _violated(condition: Condition, candidates: CandidateBatch) -> tuple[Stretch, ...]:
    """Where the formula under the outermost `always` is violated, on each road."""
    from ..stl import Always

    formula = condition.formula
    inner = formula.operand if isinstance(formula, Always) else formula
    found: list[Stretch] = []
    for axis in axes_of(condition, candidates):
        positions, values, wrap = axis_signals(condition, axis, 1, candidates)
        trace = np.atleast_2d(inner.robustness(positions, values, wrap=wrap))[0]
        low, high = 0.0, np.inf
        if isinstance(formula, Always) and formula.interval is not None:
            low, high = formula.interval.lo, formula.interval.hi
        inside = (positions >= positions[0] + low) & (positions <= positions[0] + high)
        name = road_name(condition, axis, candidates)
        found.extend(_runs(name, positions, (trace < 0.0) & inside))
    return tuple(found)


def road_name(condition: Condition, axis: Any, candidates: CandidateBatch) -> str:
    """The road whose arc length `axis` a condition is judged over."""
    for binding in condition.signals:
        for _, value in binding.call.options:
            role = getattr(value, "role", None)
            if role == "road":
                return str(getattr(value, "name", ""))
            if role == "network":
                return f"{getattr(value, 'name', '')}/{axis.edge}"
    return ""


def _runs(road: str, positions: Any, wrong: Any) -> list[Stretch]:
    padded = np.concatenate([[False], wrong, [False]])
    starts = np.flatnonzero(padded[1:] & ~padded[:-1])
    ends = np.flatnonzero(~padded[1:] & padded[:-1]) - 1
    return [
        Stretch(road, float(positions[a]), float(positions[b]))
        for a, b in zip(starts, ends, strict=True)
    ]


def _finite(rho: float) -> float | None:
    return rho if np.isfinite(rho) else None


def _plain(value: Any) -> Any:
    return value if isinstance(value, str | int | float | bool | list | tuple | dict) else None
