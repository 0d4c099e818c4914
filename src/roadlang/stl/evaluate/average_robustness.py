"""Robustness averaged over windows: it also reflects how early and how long a formula holds."""

from __future__ import annotations

from functools import reduce

import numpy as np

from ..formula import formulas as f
from ..formula import terms as t
from ..formula.normal_form import normal_form
from ..formula.variables import variables_of
from .axis import SamplePositions
from .evaluation import at_start, everywhere
from .graph_operations import BOOLEAN
from .schedule import Span
from .sliding_and_until import GREATEST, LEAST, Extreme
from .trace import FloatArray, Positions, SampledSignals, Signals
from .windows import BoolArray, Windows

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
    trace = SampledSignals.of(positions, signals, variables_of(formula), wrap)
    satisfied = everywhere(formula, trace, BOOLEAN) > 0
    values = _averaged(formula, trace, satisfied, (0, trace.samples - 1))
    return values if trace.batched else values[0]


def average_rho(
    formula: f.Formula, positions: Positions, signals: Signals, *, wrap: float | None = None
) -> FloatArray:
    """Averaged robustness at the first sample, (V,) or a scalar; computes no more than it needs."""
    trace = SampledSignals.of(positions, signals, variables_of(formula), wrap)
    satisfied = at_start(formula, trace, BOOLEAN)[:, None] > 0
    values = _averaged(formula, trace, satisfied, (0, 0))[:, 0]
    return values if trace.batched else values[0]


def _averaged(
    formula: f.Formula, trace: SampledSignals, satisfied: BoolArray, span: Span
) -> FloatArray:
    plain = normal_form(formula)
    with np.errstate(over="ignore"):  # sums of huge margins are infinite
        parts = [_Averages(trace, sign).values(plain, span) for sign in (1, -1)]
    values: FloatArray = np.where(satisfied, *parts)
    return values


class _Averages:
    """Values made of the positive (`sign` 1) or negative parts of all margins."""

    def __init__(self, trace: SampledSignals, sign: int) -> None:
        self.trace, self.sign = trace, sign
        self.axis = SamplePositions.of(trace.positions, trace.wrap)

    def values(self, formula: f.Formula, span: Span) -> FloatArray:
        """Of a formula in normal form at the samples first..last, (V, last - first + 1)."""
        match formula:
            case f.Truth() | f.Comparison():
                margins = everywhere(formula, self.trace)[:, span[0] : span[1] + 1]
                return self._clipped(margins, span)
            case f.Not(operand):
                return -_Averages(self.trace, -self.sign).values(operand, span)
            case f.LogicalJunction(operands):
                extreme = LEAST if formula.least else GREATEST
                parts = (self.values(operand, span) for operand in operands)
                return reduce(extreme.ufunc, parts, self._nothing(extreme, span))
            case f.UnaryTemporal():
                return self._mean_extreme(formula, span)
            case f.BinaryTemporal():
                return self._mean_witness(formula, span)
            case f.SampleStep() | f.AtLeast():
                return self._as_robustness(formula, span)
        raise TypeError(f"not in normal form: {formula!r}")

    def _nothing(self, extreme: Extreme, span: Span) -> FloatArray:
        return self._clipped(np.full((1, 1), extreme.identity), span)

    def _clipped(self, values: FloatArray, span: Span) -> FloatArray:
        limit = np.maximum if self.sign > 0 else np.minimum
        shape = self.trace.variants, span[1] - span[0] + 1
        return np.array(np.broadcast_to(limit(values, 0.0), shape))

    def _as_robustness(self, formula: f.SampleStep | f.AtLeast, span: Span) -> FloatArray:
        """What is not averaged: the operator over the values of its operand."""
        columns = {_OPERAND: self.values(formula.operand, (0, self.trace.samples - 1))}
        margin = f.Comparison(">", t.Variable(_OPERAND), t.Constant(0.0))
        trace = SampledSignals.of(self.trace.positions, columns, columns, self.trace.wrap)
        found = everywhere(formula.with_parts([margin]), trace)
        return self._clipped(found[:, span[0] : span[1] + 1], span)

    def _mean_extreme(self, formula: f.UnaryTemporal, span: Span) -> FloatArray:
        extreme = LEAST if formula.least else GREATEST
        windows = self.axis.windows(formula.reach, span, past=formula.past)
        if windows is None:
            return self._nothing(extreme, span)
        values = _ordered(self.values(formula.operand, windows.span), windows)
        if windows.count == 1:
            reached = values[:, windows.starts[0] : windows.ends[0] + 1]
            total = extreme.ufunc.accumulate(reached, axis=1).sum(axis=1, keepdims=True)
            return self._means(total, windows, extreme, span)
        latest = np.full((values.shape[0], windows.count), extreme.identity)
        total = np.zeros_like(latest)
        for step in range(int((windows.ends - windows.starts).max()) + 1):
            inside = windows.starts + step <= windows.ends
            reached = values[:, (windows.starts + step)[inside]]
            latest[:, inside] = extreme.ufunc(latest[:, inside], reached)
            total[:, inside] += latest[:, inside]
        return self._means(total, windows, extreme, span)

    def _mean_witness(self, formula: f.BinaryTemporal, span: Span) -> FloatArray:
        windows = self.axis.windows(formula.reach, span, past=formula.past, path=True)
        if windows is None:
            return self._nothing(GREATEST, span)
        on_path, witness = (
            _ordered(self.values(part, windows.span), windows) for part in formula.parts
        )
        present = windows.first + np.arange(windows.count)
        best = np.full((witness.shape[0], windows.count), -np.inf)
        held, total = np.full_like(best, np.inf), np.zeros_like(best)
        for step in range(int((windows.ends - present).max()) + 1):
            place = np.minimum(present + step, witness.shape[1] - 1)
            inside = (present + step <= windows.ends) & (present + step >= windows.starts)
            found = np.minimum(witness[:, place], held)
            best = np.where(inside, np.maximum(best, found), best)
            total[:, inside] += best[:, inside]
            held = np.minimum(held, on_path[:, place])
        return self._means(total, windows, GREATEST, span)

    def _means(
        self, total: FloatArray, windows: Windows, extreme: Extreme, span: Span
    ) -> FloatArray:
        counts = windows.ends - windows.starts + 1
        means = np.where(counts > 0, total / np.maximum(counts, 1), extreme.identity)
        return self._clipped(means[:, ::-1] if windows.flipped else means, span)


def _ordered(values: FloatArray, windows: Windows) -> FloatArray:
    """(V, n) the samples of the span of the windows, as they count them."""
    return np.tile(values[:, ::-1] if windows.flipped else values, (1, windows.laps))
