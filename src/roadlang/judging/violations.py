"""Where along its roads a formula is violated."""

from __future__ import annotations

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..geometry.arrays import Booleans, Floats
from ..ir.scene import ViolatedSegment
from ..ir.values import Condition
from ..stl import Always
from ..stl.evaluate.axis import SamplePositions
from .road_conditions import ConditionTrace, condition_traces


def violated_stretches(
    condition: Condition, candidates: CandidateBatch
) -> tuple[ViolatedSegment, ...]:
    """Where the formula under the outermost `always` is violated, on each road, of the only
    candidate."""
    formula = condition.formula
    inner = formula.operand if isinstance(formula, Always) else formula
    found: dict[ViolatedSegment, None] = {}
    for trace in condition_traces(condition, candidates):
        if trace.absent is not None and trace.absent[0]:
            continue
        semantics = condition.evaluation.semantics
        truth = inner.truth(trace.positions, trace.values, wrap=trace.wrap, semantics=semantics)
        truth = np.atleast_2d(truth)[0]
        counted = np.ones(len(trace.positions), dtype=bool)
        if isinstance(formula, Always) and formula.interval is not None:
            counted = _in_window(formula, trace)
        found |= dict.fromkeys(_runs(trace.road, trace.positions, ~truth & counted))
    return tuple(found)


def _in_window(formula: Always, trace: ConditionTrace) -> Booleans:
    """(S,) the samples that `always[a, b]` looks at from the first one."""
    counted = np.zeros(len(trace.positions), dtype=bool)
    axis = SamplePositions.of(trace.positions, trace.wrap)
    windows = axis.windows(formula.interval, (0, 0), past=False)
    if windows is not None:
        counted[windows.samples(0)] = True
    return counted


def _runs(road: str, positions: Floats, wrong: Booleans) -> list[ViolatedSegment]:
    padded = np.concatenate([[False], wrong, [False]])
    starts = np.flatnonzero(padded[1:] & ~padded[:-1])
    ends = np.flatnonzero(~padded[1:] & padded[:-1]) - 1
    return [
        ViolatedSegment(road, float(positions[first]), float(positions[last]))
        for first, last in zip(starts, ends, strict=True)
    ]
