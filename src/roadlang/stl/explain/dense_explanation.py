"""Why a formula has its robustness where signals are held or linear between samples."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ..dense.evaluation import DenseEvaluation, refuse_laps
from ..dense.grids import GridSignals, GridsOrSignals
from ..dense.piecewise import PiecewiseLinear, constant, together
from ..dense.verdicts import dense_range, dense_verdict, operators_end
from ..evaluate.trace import Positions, checked_variant
from ..formula import formulas as f
from ..formula.evaluation_options import Semantics
from ..formula.interval import UNBOUNDED
from ..formula.normal_form import normal_form
from .causes import ViolationInterval
from .explanation import Explanation, Link

_SIDES = (-1, 0, 1)


class SidedTime(NamedTuple):
    """A time, counted from the start, or (`side` -1 or 1) the limit there from one side."""

    time: float
    side: int


def explain_between_samples(
    formula: f.Formula,
    positions: Positions,
    signals: GridsOrSignals,
    semantics: Semantics,
    *,
    variant: int = 0,
    wrap: float | None = None,
    finished: bool = False,
) -> Explanation:
    """Explain the robustness at the start of one variant.

    `stretches` is the stretch around the deciding moment alone. Raises DiagnosticError RL311 as
    `rho` does.
    """
    refuse_laps(wrap, semantics)
    grids = GridSignals.of(positions, signals, formula.variables)
    variant = checked_variant(variant, grids.variants)
    finder = _DenseFinder(DenseEvaluation(grids, semantics, variant))
    chain, empty = finder.chain(normal_form(formula))
    last, moment = chain[-1]
    lo, hi = (np.atleast_1d(end) for end in dense_range(formula, positions, signals, semantics))
    found = dense_verdict(formula, positions, signals, semantics, finished=finished)
    verdicts = np.atleast_1d(found)
    names = sorted(last.variables) if isinstance(last, f.Comparison) else []
    links = [(formula, chain[0][1]), *chain[1:]]
    return Explanation(
        formula=str(formula),
        rho=finder.value(chain[0][0], chain[0][1]),
        range=(float(lo[variant]), float(hi[variant])),
        verdict=verdicts[variant].item(),
        chain=tuple(
            Link(str(shown), grids.origin + at.time, finder.value(part, at))
            for (shown, _), (part, at) in zip(links, chain, strict=True)
        ),
        position=grids.origin + moment.time,
        predicate=str(last),
        values={name: finder.signal(name, moment) for name in names},
        window_empty=empty,
        beyond_end=tuple(map(str, operators_end(grids).operators_beyond(formula))) * finished,
        stretches=finder.stretches(chain, grids.origin) if verdicts[variant] == "violated" else (),
    )


class _DenseFinder:
    """Follows the extremes from the root down to a comparison at a moment."""

    def __init__(self, evaluation: DenseEvaluation) -> None:
        self.evaluation = evaluation
        self.end = float(evaluation.grids.span[-1])
        self.rounding = 1e3 * evaluation.grids.rounding()

    def value(self, formula: f.Formula, at: SidedTime) -> float:
        return _limit(self.evaluation.formula(formula), at)

    def signal(self, name: str, at: SidedTime) -> float:
        evaluation = self.evaluation
        linear = evaluation.semantics == "linear"
        return _limit(evaluation.grids.function(name, evaluation.variant, linear), at)

    def chain(self, formula: f.Formula) -> tuple[list[tuple[f.Formula, SidedTime]], bool]:
        """Sub-formulas and moments, and whether what decides is an empty window.

        The chain ends early where no moment that is looked at has the robustness.
        """
        links = [(formula, SidedTime(0.0, 0))]
        while not isinstance(links[-1][0], f.Comparison | f.Truth):
            following = self._next(*links[-1])
            if following is None:
                return links, bool(links[-1][0].parts) and math.isinf(self.value(*links[-1]))
            links.append(following)
        return links, False

    def _next(self, formula: f.Formula, at: SidedTime) -> tuple[f.Formula, SidedTime] | None:
        rho = self.value(formula, at)
        if isinstance(formula, f.Not):
            return formula.operand, at
        if isinstance(formula, f.LogicalJunction):
            found = [(part, at) for part in formula.operands]
        elif isinstance(formula, f.UnaryTemporal):
            found = self._moments(formula.operand, formula, at)
        elif isinstance(formula, f.AtLeast):
            found = self._moments(formula.operand, formula, at, level=rho)
        elif isinstance(formula, f.BinaryTemporal):
            whole = type(formula)(None, formula.left, formula.right)
            found = self._moments(formula.right, formula, at)
            found += self._moments(formula.left, whole, at) if found else []
        else:
            found = []
        best = min(found, key=lambda link: _apart(self.value(*link), rho), default=None)
        if best is None or _apart(self.value(*best), rho) > self.rounding:
            return None
        return best

    def _moments(
        self,
        part: f.Formula,
        formula: f.TemporalOperator,
        at: SidedTime,
        level: float | None = None,
    ) -> list[tuple[f.Formula, SidedTime]]:
        """The moments of the window among which the extremes of `part` are, and at which it crosses
        the level."""
        interval = formula.window or UNBOUNDED
        ends = [at.time - interval.hi, at.time - interval.lo]
        if not formula.past:
            ends = [at.time + interval.lo, at.time + interval.hi]
        low, high = max(ends[0], 0.0), min(ends[1], self.end)
        if low > high + self.evaluation.grids.tolerance:
            return []
        # Where the sides of `until` cross, neither of them alone has a breakpoint.
        whole = f.And(formula.parts) if len(formula.parts) > 1 else part
        function = self.evaluation.formula(whole)
        if level is not None and math.isfinite(level):
            crossing = constant(level, function.times, function.tolerance)
            function, _ = together(function, crossing, crossings=True)
        times = function.times
        inside = times[(times > low) & (times < high)].tolist()
        found = [SidedTime(time, side) for time in inside for side in _SIDES]
        edges = [] if low == high else [low, high]
        found += [SidedTime(time, side) for time in edges for side in _SIDES]
        found += [SidedTime(low, at.side)] if low == high else []
        return [(part, moment) for moment in found]

    def stretches(
        self, chain: list[tuple[f.Formula, SidedTime]], origin: float
    ) -> tuple[ViolationInterval, ...]:
        """Around the deciding moment, for as long as the comparison fails."""
        last, at = chain[-1]
        if not isinstance(last, f.Comparison):
            return ()
        if sum(isinstance(part, f.Not) for part, _ in chain) % 2:
            last = normal_form(last, negated=True)
            assert isinstance(last, f.Comparison)
        evaluation = self.evaluation
        truth = DenseEvaluation(
            evaluation.grids, evaluation.semantics, evaluation.variant, boolean=True
        ).formula(last)
        first, final = _false_around(truth, at.time)
        margin = evaluation.formula(last)
        margins = [
            (_limit(margin, SidedTime(time, side)), time)
            for time in {first, final, at.time, *margin.times.tolist()}
            if first <= time <= final
            for side in _SIDES
            if (time > first or side >= 0) and (time < final or side <= 0)
        ]
        worst, place = min(margins)
        signals = tuple(sorted(last.variables))
        found = ViolationInterval(
            origin + first, origin + final, str(last), signals, worst, origin + place
        )
        return (found,)


def _false_around(truth: PiecewiseLinear, time: float) -> tuple[float, float]:
    """The ends of the time around a moment for which something is false."""
    index = int(np.argmin(np.abs(truth.times - time)))
    if truth.times[index] > time + truth.tolerance:
        index -= 1
    first = last = index
    while first > 0 and truth.before[first - 1] < 0 and truth.at[first - 1] < 0:
        first -= 1
    if first > 0 and truth.before[first - 1] < 0:
        first -= 1
    while last < truth.times.size - 1 and truth.after[last] < 0:
        last += 1
        if truth.at[last] > 0:
            break
    return float(truth.times[first]), float(truth.times[last])


def _limit(function: PiecewiseLinear, at: SidedTime) -> float:
    limits = function.limits(np.array([at.time]))
    return float(limits[at.side + 1][0])


def _apart(a: float, b: float) -> float:
    return 0.0 if a == b else abs(a - b) if math.isfinite(a - b) else math.inf
