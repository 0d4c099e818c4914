"""From the syntax tree of a formula to the formula; numbers are distinguished from statements."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, cast, get_args

from ...diagnostics import (
    Code,
    Diagnostic,
    DiagnosticError,
    Fix,
    Span,
    diagnose,
    did_you_mean,
    nearest,
)
from ...syntax.tree import nodes as ast
from ..formula import formulas as f
from ..formula import terms as t
from ..formula.interval import Interval, interval_help
from . import unit_factors as units
from .measure_comparisons import (
    all_of,
    count_with_unit,
    measure_in,
    measured_formula,
    not_a_constant,
    not_compared,
    written_measures,
)

_NUMBER_NODES = (
    ast.NumberLiteral,
    ast.Name,
    ast.Member,
    ast.NegateExpression,
    ast.ArithmeticExpression,
    ast.CallExpression,
)
_FORMULA_NODES = (
    ast.Boolean,
    ast.ComparisonExpression,
    ast.NotExpression,
    ast.Temporal,
    ast.Binding,
    ast.Logic,
)
_NOTHING = f.Truth(False)
_ZERO = t.Constant(0.0)


class FormulaReader:
    """Converts expressions; what is wrong with them is collected in `faults`."""

    def __init__(self) -> None:
        self.faults: list[Diagnostic] = []
        self.compared_with_units: dict[str, Span] = {}
        """Signals that are compared with a number that has a unit, and where that is."""
        self.interval_with_unit: Span | None = None
        self._with_unit: Span | None = None
        self._axes: dict[str, Span] = {}

    def formula(self, node: ast.Expression) -> f.Formula:
        """A statement that holds or not. A number in its place is RL320."""
        match node:
            case ast.GroupExpression(inner):
                return self.formula(inner)
            case ast.Boolean(value):
                return f.Truth(value)
            case ast.ComparisonExpression():
                return self._comparison(node)
            case ast.NotExpression(operand):
                return f.Not(self.formula(operand))
            case ast.Temporal(word, interval, operand):
                bounds = self._interval(interval)
                return f.compound(word, [self.formula(operand)], bounds)
            case ast.Binding(word, interval, left, right):
                before, bounds = self.formula(left), self._interval(interval)
                return f.compound(word, [before, self.formula(right)], bounds)
            case ast.Logic(word, operands):
                return f.compound(word, [self.formula(operand) for operand in operands])
        if isinstance(node, ast.MeasureExpression):
            self.faults.append(not_compared(node))
            return _NOTHING
        if isinstance(node, ast.CallExpression) and _dotted(node.function) not in get_args(
            t.FunctionName
        ):
            self._unknown_function(node)
            return _NOTHING
        if isinstance(node, _NUMBER_NODES):
            text = " ".join(node.span.text.split())
            self._fault(
                Code.NUMBER_AS_FORMULA,
                node.span,
                help=f"compare it: `{text} > 0`",
                fixes=(Fix(node.span, f"({text} > 0)"),),
                text=text,
            )
            return _NOTHING
        self._unfit(node)
        return _NOTHING

    def term(self, node: ast.Expression) -> t.Term:
        """A number at each sample. A statement in its place is RL321."""
        match node:
            case ast.GroupExpression(inner):
                return self.term(inner)
            case ast.NumberLiteral():
                return t.Constant(self._number(node))
            case ast.Name(text, quoted):
                is_infinity = text == "inf" and not quoted
                return t.Constant(math.inf) if is_infinity else t.Variable(text)
            case ast.Member():
                return t.Variable(_dotted(node))
            case ast.NegateExpression(operand):
                negated = self.term(operand)
                if isinstance(negated, t.Constant):
                    return t.Constant(-negated.value)
                return t.Negate(negated)
            case ast.ArithmeticExpression(operator, left, right):
                op = cast(t.ArithmeticOperator, operator)
                return t.Arithmetic(op, self.term(left), self.term(right))
            case ast.CallExpression():
                return self._call(node)
        if isinstance(node, ast.MeasureExpression):
            self.faults.append(not_compared(node))
        elif isinstance(node, _FORMULA_NODES):
            hint = "for two formulas that hold together write `iff`, for exactly one `xor`"
            self._fault(
                Code.FORMULA_AS_NUMBER, node.span, help=hint, text=" ".join(node.span.text.split())
            )
        else:
            self._unfit(node)
        return _ZERO

    def _comparison(self, node: ast.ComparisonExpression) -> f.Formula:
        """`a < b < c` says both, of the same `b`."""
        if any(measure_in(operand) for operand in node.operands):
            return self._measured(node)
        self._with_unit = None
        terms = [self.term(operand) for operand in node.operands]
        if self._with_unit is not None:
            parts = (part for term in terms for part in term.walk())
            names = sorted(part.name for part in parts if isinstance(part, t.Variable))
            self.compared_with_units |= dict.fromkeys(names, self._with_unit)
        pairs = tuple(
            f.Comparison(cast(f.ComparisonOperator, operator), left, right)
            for operator, left, right in zip(node.operators, terms, terms[1:], strict=False)
        )
        return pairs[0] if len(pairs) == 1 else f.And(pairs)

    def _measured(self, node: ast.ComparisonExpression) -> f.Formula:
        """`1 <= count[0, 10] (p) <= 3`."""
        found = written_measures(node)
        if isinstance(found, Diagnostic):
            self.faults.append(found)
            return _NOTHING
        known: dict[int, tuple[Interval | None, f.Formula]] = {}
        parts = []
        for measure, op, number in found:
            if id(measure) not in known:
                interval = self._interval(measure.interval)
                known[id(measure)] = interval, self.formula(measure.operand)
            amount = self._amount(measure, number)
            parts.append(measured_formula(measure.word, *known[id(measure)], op, amount))
        return all_of(parts)

    def _amount(self, measure: ast.MeasureExpression, node: ast.Expression) -> float:
        """What a count or duration is compared with."""
        number = self.term(node)
        if not isinstance(number, t.Constant):
            self.faults.append(not_a_constant(measure, node.span))
            return 0.0
        if isinstance(node, ast.NumberLiteral) and node.unit:
            if measure.word == "count":
                self.faults.append(count_with_unit(node))
            else:
                self._check_axis((node,))
        return number.value

    def _call(self, node: ast.CallExpression) -> t.Term:
        name = _dotted(node.function)
        known = get_args(t.FunctionName)
        arguments = [self.term(argument.value) for argument in node.arguments]
        if name not in known:
            self._unknown_function(node)
            return _ZERO
        fits = len(arguments) == 1 if name == "abs" else len(arguments) >= 2
        if not fits or any(argument.key for argument in node.arguments):
            expected = "one number" if name == "abs" else "two numbers or more, without names"
            hint = "write `abs(x)`" if name == "abs" else f"write `{name}(x, y)`"
            self._fault(
                Code.WRONG_FORMULA_ARGUMENTS, node.span, help=hint, name=name, expected=expected
            )
            return _ZERO
        return t.Apply(cast(t.FunctionName, name), tuple(arguments))

    def _unknown_function(self, call: ast.CallExpression) -> None:
        node, known = call.function, get_args(t.FunctionName)
        name = _dotted(node)
        found = nearest(name, known)
        hints = [*did_you_mean(name, known), f"the functions are {', '.join(known)}"]
        things = [a.value for a in call.arguments if isinstance(a.value, ast.Name)]
        if found is None and len(things) == len(call.arguments) > 1:
            hints.append(
                f"a signal of several agents or roads, such as `{call.span.text}`, is not in a "
                "trace: write the formula as an `expect` of the scene file, which `roadlang run` "
                "evaluates"
            )
        fixes = (Fix(node.span, found),) if found else ()
        self._fault(Code.UNKNOWN_FORMULA_FUNCTION, node.span, help=hints, fixes=fixes, name=name)

    def _number(self, node: ast.NumberLiteral) -> float:
        if node.unit:
            self._with_unit = node.span
        try:
            return node.value * units.factor(node.unit)
        except KeyError:
            hints, fixes = units.unit_help(node)
            self._fault(
                Code.UNKNOWN_FORMULA_UNIT, node.span, help=hints, fixes=fixes, unit=node.unit
            )
            return 0.0

    def _interval(self, node: ast.IntervalExpression | None) -> Interval | None:
        if node is None:
            return None
        low, high = self._bound(node.low), self._bound(node.high)
        units_of = [getattr(bound, "unit", "") for bound in (node.low, node.high)]
        if not units_of[0] and units.axis_of(units_of[1]):
            low *= units.factor(units_of[1])
        self._check_axis((node.low, node.high))
        try:
            return Interval(low, high)
        except DiagnosticError:
            lo, hi = (" ".join(bound.span.text.split()) for bound in (node.low, node.high))
            hints, meant = interval_help(low, high, lo, hi)
            fixes = (Fix(node.span, meant),) if meant else ()
            self._fault(Code.INVALID_INTERVAL, node.span, help=hints, fixes=fixes, lo=lo, hi=hi)
            return None

    def _bound(self, node: ast.Expression) -> float:
        term = self.term(node)
        if isinstance(term, t.Constant):
            return term.value
        hint = "write a number or `inf`; `roadlang mine` finds a number for a name"
        self._fault(
            Code.NON_CONSTANT_INTERVAL, node.span, help=hint, text=" ".join(node.span.text.split())
        )
        return 0.0

    def _check_axis(self, bounds: Sequence[ast.Expression]) -> None:
        """A formula is about one axis: meters along a road, or seconds."""
        for bound in bounds:
            if not isinstance(bound, ast.NumberLiteral) or not bound.unit:
                continue
            self.interval_with_unit = bound.span
            axis = units.axis_of(bound.unit)
            if axis is None:
                if units.is_unit(bound.unit):
                    hint = "write meters along a road, seconds of a drive, or no unit"
                    self._fault(Code.NO_AXIS_UNIT, bound.span, help=hint, unit=bound.unit)
                continue
            self._axes.setdefault(axis, bound.span)
            if len(self._axes) == 2:
                other = next(span for known, span in self._axes.items() if known != axis)
                hint = "write one formula for the road and one for the drive"
                self._fault(
                    Code.MIXED_INTERVAL_AXES,
                    bound.span,
                    help=hint,
                    here=bound.span.text,
                    there=other.text,
                )
                return

    def _unfit(self, node: ast.Expression) -> None:
        fixes: tuple[Fix, ...] = ()
        hint = "a formula has numbers, signals, comparisons and operators"
        if isinstance(node, ast.String) and node.value.isidentifier():
            hint, fixes = f"a signal has no quotes: `{node.value}`", (Fix(node.span, node.value),)
        elif isinstance(node, ast.Draw):
            low, high = node.low.span.text, node.high.span.text
            hint = f"draws belong to scene files; between two bounds is `{low} < x < {high}`"
        text = " ".join(node.span.text.split())
        self._fault(Code.NOT_ALLOWED_IN_FORMULA, node.span, help=hint, fixes=fixes, text=text)

    def _fault(self, code: str, span: Span, **values: Any) -> None:
        self.faults.append(diagnose(code, span, **values))


def _dotted(node: ast.Expression) -> str:
    """`ego.speed` as one name."""
    if isinstance(node, ast.Member):
        return f"{_dotted(node.of)}.{node.name.text}"
    return node.text if isinstance(node, ast.Name) else " ".join(node.span.text.split())
