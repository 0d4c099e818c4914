"""Where along a trace the comparisons fail that a violated formula would have needed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..evaluate.axis import SamplePositions
from ..evaluate.evaluation import everywhere
from ..evaluate.graph_operations import BOOLEAN
from ..evaluate.trace import FloatArray, SampledSignals
from ..formula import formulas as f
from ..formula.normal_form import normal_form

Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class ViolationInterval:
    """Neighboring samples, `start` to `end`, at all of which `predicate` (of `signals`) fails."""

    start: float
    end: float
    predicate: str
    signals: tuple[str, ...]
    worst: float
    worst_position: float


def violated_stretches(formula: f.Formula, trace: SampledSignals) -> tuple[ViolationInterval, ...]:
    """All intervals to blame if the only trace violates `formula` at its start; otherwise none."""
    plain = normal_form(formula)
    finder = _Blame(trace)
    start = np.zeros(trace.samples, dtype=bool)
    start[0] = True
    finder.spread(plain, start, False)
    found = [
        interval
        for comparison, mask in finder.guarded.items()
        for interval in _stretches(comparison, mask, trace)
    ]
    return tuple(
        sorted(found, key=lambda interval: (interval.start, interval.end, interval.predicate))
    )


class _Blame:
    """Spreads blame from the root to the comparisons, for all samples at once."""

    def __init__(self, trace: SampledSignals) -> None:
        self.trace = trace
        self.axis = SamplePositions.of(trace.positions, trace.wrap)
        self.guarded: dict[f.Comparison, Mask] = {}

    def spread(self, formula: f.Formula, samples: Mask, holding: bool) -> None:
        """Blame the parts of `formula` for being false (true, if `holding`) at `samples`."""
        truth = everywhere(formula, self.trace, BOOLEAN)[0] > 0
        samples = samples & (truth == holding)
        if not samples.any():
            return
        match formula:
            case f.Comparison():
                cause = normal_form(formula, negated=True) if holding else formula
                assert isinstance(cause, f.Comparison)
                self.guarded[cause] = self.guarded.get(cause, False) | samples
            case f.Not(operand):
                self.spread(operand, samples, not holding)
            case f.BinaryTemporal(_, left, right):
                self.spread(left, self._reached(formula, samples, path=True), holding)
                self.spread(right, self._reached(formula, samples, path=False), holding)
            case f.UnaryTemporal() | f.SampleStep() | f.AtLeast():
                reached = self._reached(formula, samples, path=False)
                self.spread(formula.parts[0], reached, holding)
            case _:
                for part in formula.parts:
                    self.spread(part, samples, holding)

    def _reached(self, formula: f.TemporalOperator, samples_of: Mask, *, path: bool) -> Mask:
        """The samples in the windows of `samples_of`; `path`: and those on the way to them."""
        past = formula.past
        reached = np.zeros(self.trace.samples, dtype=bool)
        windows = self.axis.windows(
            formula.reach, (0, self.trace.samples - 1), past=past, path=path
        )
        if windows is not None:
            low, high = windows.span
            chosen = samples_of[::-1] if past else samples_of
            reached[low : high + 1] = windows.reached(chosen, path=path)
        return reached


def _stretches(
    comparison: f.Comparison, mask: Mask, trace: SampledSignals
) -> list[ViolationInterval]:
    margins: FloatArray = everywhere(comparison, trace)[0]
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(np.int8)))
    found = []
    for first, last in zip(edges[::2], edges[1::2], strict=True):
        worst = int(first + np.argmin(margins[first:last]))
        found.append(
            ViolationInterval(
                start=float(trace.positions[first]),
                end=float(trace.positions[last - 1]),
                predicate=str(comparison),
                signals=tuple(sorted(comparison.left.variables | comparison.right.variables)),
                worst=float(margins[worst]),
                worst_position=float(trace.positions[worst]),
            )
        )
    return found
