"""Robustness of a formula over dense time: signals are held, or linear between samples."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import reduce
from typing import get_args

import numpy as np

from ...diagnostics import Code, arguments
from ..errors import check_word, stl_error
from ..evaluate.graph_operations import BOOLEAN, OF_INFINITIES, ROBUST, TERM_FUNCTIONS
from ..evaluate.sliding_and_until import GREATEST, LEAST
from ..evaluate.trace import FloatArray, Positions, checked_variant
from ..formula import formulas as f
from ..formula import terms as t
from ..formula.evaluation_options import Semantics
from ..formula.interval import UNBOUNDED
from ..formula.normal_form import normal_form
from ..formula.variables import variables_of
from .durations import lasting
from .grids import GridSignals, GridsOrSignals
from .piecewise import PiecewiseLinear, constant, extreme_of, holding, joined, together
from .windows import reaching, sliding

_BETWEEN_SAMPLES = tuple(word for word in get_args(Semantics) if word != "sampled")


def dense_rho(
    formula: f.Formula,
    positions: Positions,
    signals: GridsOrSignals,
    semantics: Semantics,
    wrap: float | None = None,
) -> FloatArray:
    """Robustness at the start: (V,), or a scalar where no signal has a variant axis."""
    refuse_laps(wrap, semantics)
    grids = GridSignals.of(positions, signals, variables_of(formula))
    values = np.array([function.at[0] for function in _functions(formula, grids, semantics)])
    return values if grids.batched else values[0]


def dense_robustness(
    formula: f.Formula,
    positions: Positions,
    signals: GridsOrSignals,
    semantics: Semantics,
    wrap: float | None = None,
) -> FloatArray:
    """Robustness at each of `positions`: (V, S), or (S,) where no signal has a variant axis.

    Raises DiagnosticError RL301 for a position at which a signal is not known.
    """
    refuse_laps(wrap, semantics)
    grids = GridSignals.of(positions, signals, variables_of(formula))
    stations = grids.checked(positions)
    values = np.array(
        [function.limits(stations)[1] for function in _functions(formula, grids, semantics)]
    )
    return values if grids.batched else values[0]


def dense_function(
    formula: f.Formula,
    positions: Positions,
    signals: GridsOrSignals,
    semantics: Semantics,
    variant: int = 0,
) -> PiecewiseLinear:
    """The robustness of one variant as a function of time, counted from the start.

    Raises DiagnosticError RL342 for semantics that are neither held nor linear.
    """
    check_word("semantics", semantics, _BETWEEN_SAMPLES)
    grids = GridSignals.of(positions, signals, variables_of(formula))
    variant = checked_variant(variant, grids.variants)
    return DenseEvaluation(grids, semantics, variant).formula(normal_form(formula))


def refuse_laps(wrap: float | None, semantics: Semantics) -> None:
    """RL312 for a closed road."""
    if wrap is not None:
        raise stl_error(Code.CLOSED_BETWEEN_SAMPLES, semantics=semantics)


def _functions(
    formula: f.Formula, grids: GridSignals, semantics: Semantics
) -> list[PiecewiseLinear]:
    plain = normal_form(formula)
    return [
        DenseEvaluation(grids, semantics, variant).formula(plain)
        for variant in range(grids.variants)
    ]


class DenseEvaluation:
    """Functions of time for one variant; equal parts are computed once. `boolean`: comparisons are
    1 where they hold and -1 where they do not."""

    def __init__(
        self, grids: GridSignals, semantics: Semantics, variant: int, *, boolean: bool = False
    ) -> None:
        check_word("semantics", semantics, get_args(Semantics))
        self.grids, self.semantics, self.variant = grids, semantics, variant
        self.boolean = boolean
        self._known: dict[f.Formula | t.Term, PiecewiseLinear] = {}

    def formula(self, formula: f.Formula) -> PiecewiseLinear:
        """The robustness of a formula in normal form. Raises DiagnosticError RL311."""
        if formula not in self._known:
            self._known[formula] = self._formula(formula)
        return self._known[formula]

    def term(self, term: t.Term) -> PiecewiseLinear:
        """The value of a term. Raises DiagnosticError RL302 or RL311."""
        if term not in self._known:
            self._known[term] = self._term(term)
        return self._known[term]

    def constants(self) -> dict[str, FloatArray]:
        """The signals that are one number, now and later, each (1,)."""
        return self.grids.constants(self.variant)

    def _constant(self, value: float) -> PiecewiseLinear:
        return constant(value, self.grids.span, self.grids.tolerance)

    def _formula(self, formula: f.Formula) -> PiecewiseLinear:
        match formula:
            case f.Truth(value):
                return self._constant(np.inf if value else -np.inf)
            case f.Comparison(op, left, right):
                return self._comparison(op, left, right)
            case f.Not(operand):
                return self.formula(operand).mapped(np.negative)
            case f.LogicalJunction(()):
                return self._constant(np.inf if formula.least else -np.inf)
            case f.LogicalJunction(operands):
                extreme = LEAST if formula.least else GREATEST
                parts = [self.formula(operand) for operand in operands]
                return reduce(lambda a, b: extreme_of(a, b, extreme), parts)
            case f.UnaryTemporal(interval, operand):
                function = self.formula(operand)
                extreme = LEAST if formula.least else GREATEST
                if formula.past:
                    function = function.reversed()
                found = sliding(function, interval or UNBOUNDED, extreme)
                return found.reversed() if formula.past else found
            case f.BinaryTemporal(interval, left, right):
                p, q = self.formula(left), self.formula(right)
                if formula.past:
                    p, q = p.reversed(), q.reversed()
                found = reaching(p, q, interval or UNBOUNDED)
                return found.reversed() if formula.past else found
            case f.AtLeast(interval, operand) if not formula.counts:
                function, reach = self.formula(operand), interval or UNBOUNDED
                return lasting(function, reach, formula.amount, self.least_time(formula))
        measured = formula.measured if isinstance(formula, f.AtLeast) else formula
        raise self.refusal(str(measured))

    def least_time(self, formula: f.AtLeast) -> float:
        """The time that is enough for a duration, as far as sums of times tell it apart."""
        slack = 16 * math.ulp(float(self.grids.span[-1]) + formula.amount)
        return formula.amount + (slack if formula.strict else -slack)

    def _comparison(self, op: str, left: t.Term, right: t.Term) -> PiecewiseLinear:
        if self.boolean:
            return holding(self._margin("<", left, right), BOOLEAN[op])
        return self._margin(op, left, right)

    def _margin(self, op: str, left: t.Term, right: t.Term) -> PiecewiseLinear:
        function = OF_INFINITIES[ROBUST["<" if op in ("<", "<=") else ">"]]
        difference = joined(*together(self.term(left), self.term(right)), function)
        if op not in ("==", "!="):
            return difference
        distance = self._absolute(difference)
        return distance if op == "!=" else distance.mapped(np.negative)

    def _term(self, term: t.Term) -> PiecewiseLinear:
        match term:
            case t.Constant(value):
                return self._constant(value)
            case t.Variable(name):
                return self.grids.function(name, self.variant, self.semantics == "linear")
        parts = [self.term(part) for part in term.parts]
        match term:
            case t.Negate():
                return parts[0].mapped(np.negative)
            case t.Apply("abs"):
                return self._absolute(parts[0])
            case t.Apply(function):
                extreme = LEAST if function == "min" else GREATEST
                return reduce(lambda a, b: extreme_of(a, b, extreme), parts)
            case t.Arithmetic(op):
                return self._arithmetic(term, op, parts)
        raise TypeError(f"not a term: {term!r}")

    def _absolute(self, function: PiecewiseLinear) -> PiecewiseLinear:
        return extreme_of(function, function.mapped(np.negative), GREATEST)

    def _arithmetic(
        self, term: t.Term, op: str, parts: Sequence[PiecewiseLinear]
    ) -> PiecewiseLinear:
        left, right = parts
        is_linear = (
            op in ("+", "-")
            or (op == "*" and (left.is_constant or right.is_constant))
            or (op == "/" and right.is_constant)
            or (left.is_constant and right.is_constant)
        )
        if self.semantics == "linear" and not is_linear:
            raise self.refusal(str(term))
        function = TERM_FUNCTIONS[op]
        with np.errstate(over="ignore"):
            return joined(*together(left, right), OF_INFINITIES.get(function, function))

    def refusal(self, text: str) -> Exception:
        """RL311: `text` has no value between samples."""
        return stl_error(Code.UNKNOWN_BETWEEN_SAMPLES, text=text, semantics=self.semantics)


def _check_rates(rates: Mapping[str, float]) -> None:
    for name, rate in arguments.mapping("rates", rates).items():
        if not arguments.number(f"rates[{name!r}]", rate) >= 0.0:
            problem = f"its rate of change is {rate}: give its greatest rate of change, 0 or more"
            raise stl_error(Code.INVALID_PARAMETER, name=name, problem=problem)


def sampling_error(
    formula: f.Formula,
    positions: Positions,
    signals: GridsOrSignals,
    rates: Mapping[str, float],
    semantics: Semantics,
) -> float:
    """How far the robustness with `semantics` held or linear can be from that of the signals
    themselves, if each changes by at most `rates[name]` per unit of the positions.

    A signal that is held is off by its rate times the longest step at most, an interpolated one by
    half of that, and robustness by no more than the comparison that is off most. Raises
    DiagnosticError RL304 for a signal without a rate, RL311 for terms that are no sums, multiples
    or extremes of signals, RL342 for semantics that are neither held nor linear and for rates
    that are below 0 or NaN.
    """
    check_word("semantics", semantics, _BETWEEN_SAMPLES)
    _check_rates(rates)
    grids = GridSignals.of(positions, signals, variables_of(formula))
    share = 0.5 if semantics == "linear" else 1.0

    def off_by(term: t.Term) -> float:
        match term:
            case t.Constant():
                return 0.0
            case t.Variable(name):
                if name not in rates:
                    raise stl_error(Code.MISSING_SIGNAL, name=name)
                return share * rates[name] * grids.longest_step(name)
            case t.Arithmetic("*", t.Constant(scale), other) | t.Arithmetic(
                "*", other, t.Constant(scale)
            ):
                return abs(scale) * off_by(other)
            case t.Arithmetic("/", other, t.Constant(scale)) if scale:
                return off_by(other) / abs(scale)
            case t.Negate() | t.Arithmetic("+" | "-"):
                return sum(off_by(part) for part in term.parts)
            case t.Apply():
                return max(off_by(part) for part in term.parts)
        raise stl_error(Code.UNKNOWN_BETWEEN_SAMPLES, text=str(term), semantics=semantics)

    comparisons = (part for part in formula.walk() if isinstance(part, f.Comparison))
    return max((off_by(part.left) + off_by(part.right) for part in comparisons), default=0.0)
