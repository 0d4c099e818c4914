"""Robustness averaged over windows: it also reflects how early and how long a formula holds."""

from __future__ import annotations

from functools import reduce

import numpy as np

from ..formula import formulas as f
from ..formula import terms as t
from ..formula.normal_form import normal_form
from .axis import SamplePositions
from .evaluation import everywhere
from .kernels import GREATEST, LEAST, Extreme
from .operations import BOOLEAN
from .trace import FloatArray, Positions, SampledSignals, Signals
from .windows import Windows

_OPERAND = "operand"


def average_robustness(
    formula: f.Formula, positions: Positions, signals: Signals, *, wrap: float | None = None
) -> FloatArray:
    """Averaged robustness at every sample, (V, S) or (S,), with the sign of robustness.

    Of `eventually[a, b] p` it is the mean, over the samples t' of the window, of the greatest p
    from the start of the window to t'; of `always` the mean of the least, of `until[a, b]` that of
    `until[a, t' - t]`; past operators alike. It is computed from the positive parts of all margins
    where the formula is satisfied, and from their negative parts where it is not (AvSTL: Akazaki
    and Hasuo, Time robustness in MTL and expressivity in hybrid system falsification, CAV 2015,
    definition 4, with every operator averaged). All else combines as robustness does. Raises
    DiagnosticError as `robustness` does.
    """
    trace = SampledSignals.of(positions, signals, formula.variables, wrap)
    plain = normal_form(formula)
    satisfied = everywhere(formula, trace, BOOLEAN) > 0
    parts = (_Averages(trace, sign).values(plain) for sign in (1, -1))
    values: FloatArray = np.where(satisfied, *parts)
    return values if trace.batched else values[0]


class _Averages:
    """Values (V, S) made of the positive (`sign` 1) or negative parts of all margins."""

    def __init__(self, trace: SampledSignals, sign: int) -> None:
        self.trace, self.sign = trace, sign
        self.axis = SamplePositions.of(trace.positions, trace.wrap)

    def values(self, formula: f.Formula) -> FloatArray:
        """Of a formula in normal form."""
        match formula:
            case f.Truth() | f.Comparison():
                return self._clipped(everywhere(formula, self.trace))
            case f.Not(operand):
                return -_Averages(self.trace, -self.sign).values(operand)
            case f.LogicalJunction(operands):
                extreme = LEAST if formula.least else GREATEST
                nothing = self._clipped(np.full(self._shape, extreme.identity))
                return reduce(extreme.ufunc, map(self.values, operands), nothing)
            case f.UnaryTemporal(_, operand):
                return self._mean_extreme(formula, self.values(operand))
            case f.BinaryTemporal(_, left, right):
                return self._mean_witness(formula, self.values(left), self.values(right))
            case f.SampleStep() | f.AtLeast():
                return self._as_robustness(formula)
        raise TypeError(f"not in normal form: {formula!r}")

    @property
    def _shape(self) -> tuple[int, int]:
        return self.trace.variants, self.trace.samples

    def _clipped(self, values: FloatArray) -> FloatArray:
        limit = np.maximum if self.sign > 0 else np.minimum
        return np.array(np.broadcast_to(limit(values, 0.0), self._shape))

    def _as_robustness(self, formula: f.SampleStep | f.AtLeast) -> FloatArray:
        """What is not averaged: the operator over the values of its operand."""
        columns = {_OPERAND: self.values(formula.operand)}
        margin = f.Comparison(">", t.Variable(_OPERAND), t.Constant(0.0))
        trace = SampledSignals.of(self.trace.positions, columns, columns, self.trace.wrap)
        return self._clipped(everywhere(formula.with_parts([margin]), trace))

    def _mean_extreme(self, formula: f.UnaryTemporal, operand: FloatArray) -> FloatArray:
        extreme = LEAST if formula.least else GREATEST
        windows = self.axis.windows(formula.reach, (0, self.trace.samples - 1), past=formula.past)
        if windows is None:
            return self._clipped(np.full(self._shape, extreme.identity))
        values = _ordered(operand, windows)
        latest = np.full((operand.shape[0], windows.count), extreme.identity)
        total = np.zeros_like(latest)
        for step in range(int((windows.ends - windows.starts).max()) + 1):
            inside = windows.starts + step <= windows.ends
            reached = values[:, (windows.starts + step)[inside]]
            latest[:, inside] = extreme.ufunc(latest[:, inside], reached)
            total[:, inside] += latest[:, inside]
        return self._means(total, windows, extreme)

    def _mean_witness(
        self, formula: f.BinaryTemporal, left: FloatArray, right: FloatArray
    ) -> FloatArray:
        span = (0, self.trace.samples - 1)
        windows = self.axis.windows(formula.reach, span, past=formula.past, path=True)
        if windows is None:
            return self._clipped(np.full(self._shape, -np.inf))
        on_path, witness = _ordered(left, windows), _ordered(right, windows)
        present = windows.first + np.arange(windows.count)
        best = np.full((left.shape[0], windows.count), -np.inf)
        held, total = np.full_like(best, np.inf), np.zeros_like(best)
        for step in range(int((windows.ends - present).max()) + 1):
            place = np.minimum(present + step, witness.shape[1] - 1)
            inside = (present + step <= windows.ends) & (present + step >= windows.starts)
            found = np.minimum(witness[:, place], held)
            best = np.where(inside, np.maximum(best, found), best)
            total[:, inside] += best[:, inside]
            held = np.minimum(held, on_path[:, place])
        return self._means(total, windows, GREATEST)

    def _means(self, total: FloatArray, windows: Windows, extreme: Extreme) -> FloatArray:
        counts = windows.ends - windows.starts + 1
        means = np.where(counts > 0, total / np.maximum(counts, 1), extreme.identity)
        return self._clipped(means[:, ::-1] if windows.flipped else means)


def _ordered(values: FloatArray, windows: Windows) -> FloatArray:
    """(V, n) the samples of the span as the windows count them."""
    low, high = windows.span
    chosen = values[:, low : high + 1]
    return np.tile(chosen[:, ::-1] if windows.flipped else chosen, (1, windows.laps))
