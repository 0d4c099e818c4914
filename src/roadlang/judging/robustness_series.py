"""Robustness along a drive."""

from __future__ import annotations

import numpy as np

from ..geometry.arrays import Floats
from ..ir.scene import Verdict
from ..ir.trace import Trace
from ..plugins.registry import Registry
from ..stl import Always
from ..stl.evaluate.measured_robustness import measured_robustness
from .drives import DriveCondition


def robustness_series(verdict: Verdict, trace: Trace, registry: Registry) -> Floats | None:
    """(T,) the robustness of `p` in `always p` at each time, of the worst member of a group; of
    another formula its own from then on. None for what is no formula over the drive."""
    if verdict.domain != "drive" or verdict.formula is None or "monitor" in verdict.formula:
        return None
    condition = DriveCondition(verdict.formula, trace, registry)
    formula = condition.formula
    inner = formula.operand if isinstance(formula, Always) else formula
    options = condition.evaluation
    series = [
        measured_robustness(inner, trace.time, values, options) for _, values in condition.choices()
    ]
    if not series:
        return None
    return np.asarray(np.min([np.broadcast_to(s, trace.time.shape) for s in series], axis=0))
