"""The least and the greatest robustness over all continuations, for signals known between samples.

Behind the last moment that is known time goes on, or it does not; if it does, signals may have any
values there. So what lies behind counts where it can help a bound, and stays away where it cannot;
the rules are those for samples (`evaluate/ranges.py`), but that a moment of the future is never
reached without all moments before it.
"""

from __future__ import annotations

import math
from functools import reduce
from typing import Literal, TypeAlias

import numpy as np

from ..evaluate.sliding_and_until import GREATEST, LEAST, Extreme
from ..evaluate.static_truth import static_truth
from ..evaluate.unseen import unseen_range
from ..formula import formulas as f
from ..formula.interval import UNBOUNDED
from .durations import lasting
from .evaluation import DenseEvaluation
from .piecewise import PiecewiseLinear, extreme_of, joined, together
from .windows import reaching, sliding

Side: TypeAlias = Literal["lower", "upper"]


class DenseBounds:
    """Both ends of the range of a variant as functions of time, from the start to some moment
    behind the last one known, after which they are constant."""

    def __init__(self, evaluation: DenseEvaluation, formula: f.Formula) -> None:
        self.evaluation = evaluation
        self.known = float(evaluation.grids.span[-1])
        self.end = self.known + 1.0 + _reach(formula)
        self._constants = evaluation.constants()

    def bound(self, formula: f.Formula, side: Side) -> PiecewiseLinear:
        """One end of the range of a formula in normal form."""
        if not formula.temporal:
            return self._extended(self.evaluation.formula(formula), self._unseen(formula, side))
        match formula:
            case f.Not(operand):
                other: Side = "upper" if side == "lower" else "lower"
                return self.bound(operand, other).mapped(np.negative)
            case f.LogicalJunction(operands):
                return self._junction(formula, operands, side)
            case f.UnaryTemporal():
                return self._slide(formula, side)
            case f.BinaryTemporal(interval, left, right):
                p, q = self.bound(left, side), self.bound(right, side)
                if formula.past:
                    return reaching(p.reversed(), q.reversed(), interval or UNBOUNDED).reversed()
                if side == "upper":
                    return reaching(p, q, interval or UNBOUNDED)
                found = reaching(p, self._absent(q, -np.inf), interval or UNBOUNDED)
                return self._with_now(found, q, formula, GREATEST)
            case f.AtLeast() if not formula.counts:
                return self._lasting(formula, side)
        raise self.evaluation.refusal(str(formula))

    def _junction(
        self, formula: f.LogicalJunction, operands: tuple[f.Formula, ...], side: Side
    ) -> PiecewiseLinear:
        """Operands without temporal operators are one: their signals are the same."""
        states = tuple(operand for operand in operands if not operand.temporal)
        parts = [part for part in operands if part.temporal]
        parts += [type(formula)(states)] if states else []
        extreme = LEAST if formula.least else GREATEST
        bounds = [self.bound(part, side) for part in parts]
        return reduce(lambda a, b: extreme_of(a, b, extreme), bounds)

    def _slide(self, formula: f.UnaryTemporal, side: Side) -> PiecewiseLinear:
        extreme = LEAST if formula.least else GREATEST
        operand, interval = self.bound(formula.operand, side), formula.interval or UNBOUNDED
        if formula.past:
            return sliding(operand.reversed(), interval, extreme).reversed()
        if (side == "lower") == formula.least:
            return sliding(operand, interval, extreme)
        found = sliding(self._absent(operand, extreme.identity), interval, extreme)
        return self._with_now(found, operand, formula, extreme)

    def _lasting(self, formula: f.AtLeast, side: Side) -> PiecewiseLinear:
        """Time that may never come adds nothing to the lower end, and all it can to the upper."""
        operand, interval = self.bound(formula.operand, side), formula.interval or UNBOUNDED
        if side == "lower":
            operand = self._absent(operand, -np.inf)
        return lasting(operand, interval, formula.amount, self.evaluation.least_time(formula))

    def _with_now(
        self,
        found: PiecewiseLinear,
        operand: PiecewiseLinear,
        formula: f.TemporalOperator,
        extreme: Extreme,
    ) -> PiecewiseLinear:
        """At a moment behind the known ones, that moment itself is there."""
        if formula.window is not None and formula.window.lo > 0:
            return found
        present = self._replaced(operand, extreme.identity, behind=False)
        return joined(*together(found, present, crossings=True), extreme.ufunc)

    def _absent(self, function: PiecewiseLinear, identity: float) -> PiecewiseLinear:
        return self._replaced(function, identity, behind=True)

    def _replaced(
        self, function: PiecewiseLinear, value: float, *, behind: bool
    ) -> PiecewiseLinear:
        """A function with another value at all moments behind the known ones, or at all others."""
        times = function.times
        limit = self.known + function.tolerance
        points = (times > limit) == behind
        pieces = (times[1:] > limit) == behind
        return PiecewiseLinear(
            times,
            np.where(points, value, function.at),
            np.where(pieces, value, function.after),
            np.where(pieces, value, function.before),
            function.tolerance,
        )

    def _extended(self, function: PiecewiseLinear, value: float) -> PiecewiseLinear:
        last = np.array([value])
        return PiecewiseLinear(
            np.append(function.times, self.end),
            np.append(function.at, last),
            np.append(function.after, last),
            np.append(function.before, last),
            function.tolerance,
        )

    def _unseen(self, formula: f.Formula, side: Side) -> float:
        lowest, highest = (float(end[0]) for end in unseen_range(formula, self._constants))
        if self.evaluation.boolean:
            known = {name: (c, c) for name, c in self._constants.items()}
            truth = static_truth(formula, known)
            lowest = 1.0 if lowest > 0 or bool(np.all(truth.certain)) else -1.0
            highest = 1.0 if highest >= 0 and bool(np.all(truth.possible)) else -1.0
        return lowest if side == "lower" else highest


def _reach(formula: f.Formula) -> float:
    """The sum of all finite bounds of intervals and of durations: nothing looks farther from the
    known part."""
    windows = [part.window for part in formula.walk() if isinstance(part, f.TemporalOperator)]
    durations = sum(part.amount for part in formula.walk() if isinstance(part, f.AtLeast))
    return durations + sum(
        bound for window in windows if window is not None for bound in (window.lo, window.hi)
        if math.isfinite(bound)
    )  # fmt: skip
