"""`count[a, b] (p) <= 3` and `duration[a, b] (p) < 2s`: from the syntax tree to STL."""

from __future__ import annotations

from dataclasses import replace

from ...diagnostics import Code, Diagnostic, Span
from ...ir.dimension import LENGTH, PURE, TIME, Dimension
from ...stl.formats.measure_comparisons import (
    all_of,
    count_with_unit,
    measure_in,
    measured_formula,
    not_a_constant,
    not_compared,
    written_measures,
)
from ...stl.formula.formulas import Formula
from ...stl.formula.interval import Interval
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..types.dimensions import dimension_of, unit_missing
from ..types.expression_types import Quantity, TypedExpression, unknown
from .formulas import (
    infer_comparison,
    infer_operand,
    interval_ends,
    interval_of,
    without_operand,
)


def infer_any_comparison(
    checker: Checker, node: ast.ComparisonExpression, context: Context
) -> TypedExpression:
    """A comparison of numbers and signals, or of a count or duration with a number."""
    if any(measure_in(operand) for operand in node.operands):
        return _infer_measured(checker, node, context)
    return infer_comparison(checker, node, context)


def infer_measure(
    checker: Checker, node: ast.MeasureExpression, context: Context
) -> TypedExpression:
    """A count or duration by itself: it has to be compared."""
    checker.infer(node.operand, context)
    return _refused(checker, not_compared(node), node.span)


def _infer_measured(
    checker: Checker, node: ast.ComparisonExpression, context: Context
) -> TypedExpression:
    found = written_measures(node)
    if isinstance(found, Diagnostic):
        return _refused(checker, found, node.span)
    known: dict[int, tuple[TypedExpression, Interval | None] | None] = {}
    parts: list[Formula] = []
    typed: TypedExpression | None = None
    for measure, op, number in found:
        if id(measure) not in known:
            known[id(measure)] = _window(checker, measure, context)
        window = known[id(measure)]
        amount = _amount(checker, measure, number, window and window[0], context)
        if window is None or amount is None:
            continue
        typed, interval = window
        assert typed.formula is not None
        parts.append(measured_formula(measure.word, interval, typed.formula, op, amount))
    if typed is None or len(parts) < len(found):
        return unknown(node.span)
    return replace(typed, span=node.span, formula=all_of(parts))


def _window(
    checker: Checker, node: ast.MeasureExpression, context: Context
) -> tuple[TypedExpression, Interval | None] | None:
    """The operand and the interval; None, reported, where either is none."""
    operand = infer_operand(checker, node.operand, context, f"`{node.word}`")
    ends = interval_ends(checker, node.interval, context)
    if operand.formula is None or ends is None:
        without_operand(checker, node, ends)
        return None
    interval = interval_of(checker, node, ends, operand.evidence)
    return None if isinstance(interval, TypedExpression) else (operand, interval)


def _amount(
    checker: Checker,
    measure: ast.MeasureExpression,
    node: ast.Expression,
    operand: TypedExpression | None,
    context: Context,
) -> float | None:
    """The number that a measure is compared with; None, reported, where it is none that fits."""
    number = checker.infer(node, context)
    if number.is_unknown:
        return None
    if not isinstance(number.type, Quantity) or number.constant is None:
        _refused(checker, not_a_constant(measure, node.span), node.span)
        return None
    if number.type.fits_any or operand is None or operand.evidence is None:
        return number.constant
    expected = _dimension(measure, operand.evidence.domain)
    if dimension_of(number) == expected:
        return number.constant
    if measure.word == "count" and isinstance(node, ast.NumberLiteral):
        _refused(checker, count_with_unit(node), node.span)
    elif number.type.bare:
        unit_missing(checker, number, expected)
    else:
        what = f"what `{measure.word}` is compared with"
        checker.report(
            Code.WRONG_DIMENSION, number.span, what=what, expected=str(expected), found=number.type
        )
    return None


def _dimension(measure: ast.MeasureExpression, domain: str) -> Dimension:
    if measure.word == "count":
        return PURE
    return LENGTH if domain == "road" else TIME


def _refused(checker: Checker, found: Diagnostic, span: Span) -> TypedExpression:
    checker.diagnostics.append(found)
    return unknown(span)
