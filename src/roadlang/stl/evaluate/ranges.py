"""The least and the greatest robustness that any continuation of a trace can give a formula.

A continuation adds samples after the last one, as many as it likes and wherever it likes. So a
later sample can make a minimum lower, whatever its value; it cannot make it higher, but it can
refrain from coming. See docs/stl.md for the rules of each operator.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Literal, TypeAlias

import numpy as np

from ..formula import formulas as f
from ..formula.normal_form import normal_form
from ..formula.strengthening import strengthened
from .ahead import extended_axis
from .axis import SamplePositions
from .evaluation import finite_first, run_at_start
from .graph import FormulaGraph, can_be_infinite
from .graph_operations import (
    BOOLEAN,
    ROBUST,
    AtUnseen,
    Extend,
    Function,
    GivenNumbers,
    Measuring,
    NumberOperation,
    PointwiseOperation,
    Reaching,
    Sliding,
    greatest,
    least,
    negative,
)
from .sliding_and_until import GREATEST, LEAST, Extreme
from .static_truth import static_truth
from .trace import FloatArray, SampledSignals
from .unseen import unseen_range

Side: TypeAlias = Literal["lower", "upper"]


def range_at_start(
    formula: f.Formula,
    trace: SampledSignals,
    leaves: Mapping[str, Function] = ROBUST,
    *,
    reverse_empty: bool = False,
    sample: int = 0,
) -> tuple[FloatArray, FloatArray]:
    """(lo, hi) at the first sample of each variant, or at another, each (V,).

    `reverse_empty`: a window between two samples counts the other way (see `EvaluationPlan.of`).
    """
    return finite_first(
        lambda infinite: _range_at(formula, trace, leaves, infinite, reverse_empty, sample)
    )


def _range_at(
    formula: f.Formula,
    trace: SampledSignals,
    leaves: Mapping[str, Function],
    infinite: bool,
    reverse_empty: bool,
    sample: int,
) -> tuple[FloatArray, FloatArray]:
    plain = normal_form(formula)
    if trace.wrap is not None or not plain.looks_ahead:
        graph = FormulaGraph.of(formula, leaves, infinite)
        axis = SamplePositions.of(trace.positions, trace.wrap)
        exact = run_at_start(graph, trace, axis, reverse_empty=reverse_empty, sample=sample)
        return exact, exact
    infinite = infinite or can_be_infinite(formula)
    lower, upper = BoundGraph(trace, leaves, infinite), BoundGraph(trace, leaves, infinite)
    other = strengthened(normal_form(formula, greatest=True))
    return (
        _bound_at(strengthened(plain), trace, "lower", lower, reverse_empty, sample),
        _bound_at(other, trace, "upper", upper, reverse_empty, sample),
    )


def _bound_at(
    formula: f.Formula,
    trace: SampledSignals,
    side: Side,
    graph: BoundGraph,
    reverse_empty: bool,
    sample: int,
) -> FloatArray:
    graph.bound(formula, side, False)
    extended = replace(trace, signals={**trace.signals, **graph.supplied})
    axis = extended_axis(formula, trace.positions)
    return run_at_start(graph, extended, axis, reverse_empty=reverse_empty, sample=sample)


class BoundGraph(FormulaGraph):
    """The graph of one end of the range. `given` is what unseen samples are worth."""

    def __init__(
        self, trace: SampledSignals, leaves: Mapping[str, Function], infinite: bool
    ) -> None:
        super().__init__(leaves, infinite)
        self.seen = trace.samples
        self.supplied: dict[str, FloatArray] = {}
        self._constants = {
            name: np.asarray(trace.signals[name][:, 0], dtype=np.float64)
            for name in trace.constants
        }

    def bound(self, formula: f.Formula, side: Side, later: bool) -> int:
        """The node of one end of the range of `formula`; `later`: at unseen samples as well."""
        if not formula.temporal:
            seen = self.formula(formula)
            return self.add(Extend(self.seen), seen, self._unseen(formula, side)) if later else seen
        match formula:
            case f.Not(operand):
                other: Side = "upper" if side == "lower" else "lower"
                return self.add(PointwiseOperation(negative), self.bound(operand, other, later))
            case f.LogicalJunction(operands):
                function = least if formula.least else greatest
                parts = _state_parts_together(type(formula), operands)
                bounds = [self.bound(part, side, later) for part in parts]
                return (
                    bounds[0]
                    if len(bounds) == 1
                    else self.add(PointwiseOperation(function), *bounds)
                )
            case f.BinaryTemporal():
                return self._reach(formula, side, later)
            case f.AtLeast():
                return self._measure(formula, side)
            case f.UnaryTemporal():
                return self._slide(formula, side, later)
            case f.SampleStep():
                return self._step(formula, side, later)
        raise TypeError(f"not in normal form: {formula!r}")

    def _slide(self, formula: f.UnaryTemporal, side: Side, later: bool) -> int:
        """Samples that are yet to come count where they help, and stay away where they do not."""
        extreme = LEAST if formula.least else GREATEST
        past = formula.past
        helped = (side == "lower") == (extreme is LEAST)
        operand = self.bound(formula.operand, side, later or (helped and not past))
        sliding = Sliding(extreme, formula.interval, past)
        if helped or (past and not later):
            return self.add(sliding, operand)
        absent = self._extended(operand, extreme.identity)
        result = self.add(sliding, absent)
        if later and _includes_now(formula):
            join = least if extreme is LEAST else greatest
            return self.add(AtUnseen(self.seen, join), result, operand)
        return result

    def _measure(self, formula: f.AtLeast, side: Side) -> int:
        """Later samples, and the time that the last one lasts, can only add to what is there."""
        measuring = Measuring(
            formula.interval, formula.amount, formula.strict, formula.counts, side
        )
        operand = self.bound(formula.operand, side, side == "upper")
        if side == "lower":
            operand = self._extended(operand, -np.inf)
        return self.add(measuring, operand)

    def _step(self, formula: f.SampleStep, side: Side, later: bool) -> int:
        """The next sample may not come; of a later sample the previous one may be any of many."""
        past, reach, lower = formula.past, formula.reach, side == "lower"
        operand = self.bound(formula.operand, side, later or not (past or lower))
        if not past and lower:
            operand = self._extended(operand, -np.inf)
        extreme = Extreme(np.minimum, -np.inf) if past and lower else GREATEST
        return self.add(Sliding(extreme, reach, past), operand)

    def _reach(self, formula: f.BinaryTemporal, side: Side, later: bool) -> int:
        """Later witnesses count for the upper end only, later failures for the lower end only."""
        past = formula.past
        reaching = Reaching(formula.interval, past)
        upper = side == "upper"
        left = self.bound(formula.left, side, later)
        right = self.bound(formula.right, side, later or (upper and not past))
        if past and not later:
            return self.add(reaching, left, right)
        if not upper:
            before = left if later else self._extended(left, np.inf)
            result = self.add(reaching, before, self._extended(right, -np.inf))
        else:
            result = self.add(reaching, self._extended(left, np.inf), right)
            if later and (past or not _includes_now(formula)):
                result = self.add(AtUnseen(self.seen, least), result, left)
        if later and _includes_now(formula):
            result = self.add(AtUnseen(self.seen, greatest), result, right)
        return result

    def _extended(self, seen: int, unseen: float) -> int:
        return self.add(Extend(self.seen), seen, self.add(NumberOperation(unseen)))

    def _unseen(self, formula: f.Formula, side: Side) -> int:
        lowest, highest = unseen_range(formula, self._constants)
        if self.leaves is BOOLEAN:
            truth = static_truth(formula, {name: (c, c) for name, c in self._constants.items()})
            lowest = np.where((lowest > 0) | truth.certain, 1.0, -1.0)
            highest = np.where((highest >= 0) & truth.possible, 1.0, -1.0)
        name = f"{side} of {formula} at an unseen sample"
        self.supplied[name] = (lowest if side == "lower" else highest)[:, None]
        return self.add(GivenNumbers(name))


def _includes_now(formula: f.TemporalOperator) -> bool:
    return formula.window is None or formula.window.lo == 0


def _state_parts_together(
    kind: type[f.LogicalJunction], operands: tuple[f.Formula, ...]
) -> tuple[f.Formula, ...]:
    """Operands without temporal operators joined into one: their signals are the same."""
    states = tuple(operand for operand in operands if not operand.temporal)
    others = tuple(operand for operand in operands if operand.temporal)
    return others if not states else (kind(states), *others)
