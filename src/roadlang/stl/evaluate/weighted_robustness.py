"""Robustness with weights for the operands of `and` and `or`."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ...diagnostics import Code, arguments
from ..errors import stl_error
from ..formula import formulas as f
from ..formula import terms as t
from ..formula.normal_form import normal_form
from ..formula.variables import variables_of
from ..formula.weighted_operands import WeightedOperands
from .evaluation import at_start, everywhere
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
    trace = SampledSignals.of(positions, signals, variables_of(formula), wrap)
    plain, evaluated = _prepared(formula, trace, weights)
    values = evaluated.values(plain)
    return values if trace.batched else values[0]


def weighted_rho(
    formula: f.Formula,
    positions: Positions,
    signals: Signals,
    weights: Mapping[f.Formula, float],
    *,
    wrap: float | None = None,
) -> FloatArray:
    """Weighted robustness at the first sample, (V,) or a scalar."""
    trace = SampledSignals.of(positions, signals, variables_of(formula), wrap)
    plain, evaluated = _prepared(formula, trace, weights)
    values = evaluated.at_start(plain)
    return values if trace.batched else values[0]


def _prepared(
    formula: f.Formula, trace: SampledSignals, weights: Mapping[f.Formula, float]
) -> tuple[f.Formula, _Weighted]:
    """The formula with a signal for each weighted operand, and what evaluates it."""
    if not isinstance(weights, Mapping):
        raise arguments.wrong_type("weights", "a map from operands to numbers above 0", weights)
    for part, weight in weights.items():
        if not (math.isfinite(weight) and weight > 0):
            raise stl_error(
                Code.INVALID_PARAMETER, name=str(part), problem="its weight is not above 0"
            )
    found = WeightedOperands.of(formula, weights)
    if found.missing:
        raise stl_error(
            Code.INVALID_PARAMETER,
            name=str(found.missing[0]),
            problem="it is not an operand of `and` or `or` in the formula",
        )
    return found.plain, _of_operands(found, trace, weights)


def _of_operands(
    found: WeightedOperands, trace: SampledSignals, weights: Mapping[f.Formula, float]
) -> _Weighted:
    columns: dict[str, NDArray[np.generic]] = dict(trace.signals)
    for name, operand in found.operands.items():
        others = {part: w for part, w in weights.items() if normal_form(part) != operand}
        inner = WeightedOperands.of(operand, others)
        columns[name] = _of_operands(inner, trace, others).values(inner.plain)
    return _Weighted(replace(trace, signals=columns), found.weights)


class _Weighted:
    """Values of formulas in normal form."""

    def __init__(self, trace: SampledSignals, weights: Mapping[f.Formula, float]) -> None:
        self.trace, self.weights = trace, weights

    def values(self, formula: f.Formula) -> FloatArray:
        """At every sample, (V, S)."""
        shape = self.trace.variants, self.trace.samples
        return np.broadcast_to(self._evaluated(formula, everywhere, self.values), shape)

    def at_start(self, formula: f.Formula) -> FloatArray:
        """At the first sample, (V,)."""
        found = self._evaluated(formula, at_start, self.at_start)
        return np.broadcast_to(found, (self.trace.variants,))

    def _evaluated(
        self,
        formula: f.Formula,
        unweighted: Callable[[f.Formula, SampledSignals], FloatArray],
        of_operand: Callable[[f.Formula], FloatArray],
    ) -> FloatArray:
        inner = (part for operand in formula.parts for part in operand.walk())
        if not any(part in self.weights for part in inner):
            return unweighted(formula, self.trace)
        if isinstance(formula, f.LogicalJunction):
            parts = [of_operand(part) for part in formula.operands]
            if any(part in self.weights for part in formula.operands):
                return _joined(formula.least, parts, self._shares(formula.operands))
            return _extreme(formula.least, parts)
        assert isinstance(formula, f.Compound)
        columns = {f"operand {k}": self.values(part) for k, part in enumerate(formula.parts)}
        margins = [f.Comparison(">", t.Variable(name), t.Constant(0.0)) for name in columns]
        trace = SampledSignals.of(self.trace.positions, columns, columns, self.trace.wrap)
        return unweighted(formula.with_parts(margins), trace)

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
