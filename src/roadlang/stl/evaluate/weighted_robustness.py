"""Robustness with weights for the operands of `and` and `or`."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from ...diagnostics import Code
from ..errors import stl_error
from ..formula import formulas as f
from ..formula import terms as t
from ..formula.normal_form import normal_form
from .evaluation import everywhere
from .trace import FloatArray, Positions, SampledSignals, Signals


def weighted_robustness(
    formula: f.Formula,
    positions: Positions,
    signals: Signals,
    weights: Mapping[f.Formula, float],
    *,
    wrap: float | None = None,
) -> FloatArray:
    """Robustness at every sample, (V, S) or (S,), with weights for operands of `and` and `or`.

    With the weights of its operands divided by their sum, w_i (1 where none is given), the
    robustness of `and` is the minimum of r_i (1 - w_i) for r_i > 0 and r_i w_i otherwise, and that
    of `or` the maximum of r_i w_i for r_i > 0 and r_i (1 - w_i) otherwise: a violation of an
    operand with a large weight counts more. The sign is that of robustness, and an `and` or `or`
    without a weighted operand keeps its usual robustness (Mehdipour, Vasile, Belta, Specifying user
    preferences using weighted signal temporal logic, L-CSS 2021). Raises DiagnosticError RL342 for
    a weight that is not positive or belongs to no operand, and as `robustness` does.
    """
    trace = SampledSignals.of(positions, signals, formula.variables, wrap)
    known = {normal_form(part): weight for part, weight in weights.items()}
    plain = normal_form(formula)
    _check(plain, known)
    values = _Weighted(trace, known).values(plain)
    return values if trace.batched else values[0]


def _check(formula: f.Formula, weights: Mapping[f.Formula, float]) -> None:
    operands = {
        operand
        for part in formula.walk()
        if isinstance(part, f.LogicalJunction)
        for operand in part.operands
    }
    for part, weight in weights.items():
        if not (math.isfinite(weight) and weight > 0):
            raise stl_error(
                Code.INVALID_PARAMETER, name=str(part), problem="its weight is not above 0"
            )
        if part not in operands:
            raise stl_error(
                Code.INVALID_PARAMETER,
                name=str(part),
                problem="it is not an operand of `and` or `or` in the formula",
            )


class _Weighted:
    """Values (V, S) of formulas in normal form."""

    def __init__(self, trace: SampledSignals, weights: Mapping[f.Formula, float]) -> None:
        self.trace, self.weights = trace, weights

    def values(self, formula: f.Formula) -> FloatArray:
        inner = (part for operand in formula.parts for part in operand.walk())
        if not any(part in self.weights for part in inner):
            values = everywhere(formula, self.trace)
            return np.broadcast_to(values, (self.trace.variants, self.trace.samples))
        if isinstance(formula, f.LogicalJunction):
            parts = [self.values(part) for part in formula.operands]
            if any(part in self.weights for part in formula.operands):
                shares = self._shares(formula.operands)
                return _joined(formula.least, parts, shares)
            return _extreme(formula.least, parts)
        assert isinstance(formula, f.Compound)
        columns = {f"operand {k}": self.values(part) for k, part in enumerate(formula.parts)}
        margins = [f.Comparison(">", t.Variable(name), t.Constant(0.0)) for name in columns]
        trace = SampledSignals.of(self.trace.positions, columns, columns, self.trace.wrap)
        return everywhere(formula.with_parts(margins), trace)

    def _shares(self, operands: Sequence[f.Formula]) -> FloatArray:
        weights = np.array([self.weights.get(operand, 1.0) for operand in operands])
        shares: FloatArray = weights / weights.sum()
        return shares


def _joined(least: bool, parts: Sequence[FloatArray], shares: FloatArray) -> FloatArray:
    below = shares if least else 1.0 - shares
    return _extreme(
        least, [_scaled(part, factor) for part, factor in zip(parts, below, strict=True)]
    )


def _scaled(values: FloatArray, below: float) -> FloatArray:
    """Times `below` where it is negative, and times 1 - `below` elsewhere; infinities stay."""
    finite = np.where(np.isinf(values), 0.0, values)
    factor = np.where(values > 0, 1.0 - below, below)
    scaled: FloatArray = np.where(np.isinf(values), values, finite * factor)
    return scaled


def _extreme(least: bool, parts: Sequence[FloatArray]) -> FloatArray:
    found: FloatArray = (np.minimum if least else np.maximum).reduce(parts)
    return found
