"""Comparisons, logic and temporal operators: from the syntax tree to STL."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from ...diagnostics import Code, Fix, Span
from ...ir.dimension import LENGTH, TIME, Dimension
from ...ir.values import Condition, NumberBinding, Reference
from ...stl.formula.formulas import And, Comparison, Formula, Not, Truth, compound
from ...stl.formula.interval import Interval, interval_help
from ...stl.formula.terms import Constant, Variable
from ...syntax.printing.nodes import one_line
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..types.arithmetic import common_domain, terms_of
from ..types.dimensions import common_dimension, dimension_of, unit_missing
from ..types.expression_types import (
    BooleanType,
    DomainEvidence,
    FormulaType,
    Quantity,
    SignalType,
    TypedExpression,
    unknown,
)
from ..types.number_terms import distinct
from .turned_signs import turned_at_least


def infer_comparison(
    checker: Checker, node: ast.ComparisonExpression, context: Context
) -> TypedExpression:
    """`a < b`, or a chain: each operator holds."""
    parts = [checker.infer(operand, context) for operand in node.operands]
    if any(part.is_unknown for part in parts):
        return unknown(node.span)
    for part in parts:
        if not isinstance(part.type, Quantity | SignalType):
            expected = "a number or a signal"
            return checker.report(
                Code.WRONG_TYPE, part.span, what="a comparison", expected=expected, found=part.type
            )
    if common_dimension(checker, parts, "compared") is None:
        return unknown(node.span)
    for operator, left, right in zip(node.operators, parts, parts[1:], strict=False):
        # A lone `=` is reported already.
        is_written = operator in node.span.text
        if operator in ("==", "!=") and is_written and not _is_integer(right):
            help_ = _with_tolerance(operator, left, right)
            checker.report(Code.FLOAT_EQUALITY, node.span, operator=operator, help=help_)
    evidence = common_domain(checker, parts)
    if isinstance(evidence, TypedExpression):
        return evidence
    terms, numbers = terms_of(parts)
    pairs = [
        Comparison(op, left, right)  # type: ignore[arg-type]
        for op, left, right in zip(node.operators, terms, terms[1:], strict=False)
    ]
    formula: Formula = pairs[0] if len(pairs) == 1 else And(tuple(pairs))
    return _formula(node.span, formula, evidence, parts, numbers)


def _with_tolerance(operator: str, left: TypedExpression, right: TypedExpression) -> str:
    """What to write instead of `left == right`, or `!=`."""
    sign, one, other = "<" if operator == "==" else ">", left.span.text, right.span.text
    is_zero = right.constant == 0.0
    difference = f"abs({one})" if is_zero else f"abs({one} - ({other}))"
    owner, _, signal = one.rpartition(".")
    touched = f", or `{owner}.contacts {operator} 0`" if signal == "collision" else ""
    return f"compare with a tolerance: `{difference} {sign} TOLERANCE`{touched}"


def _is_integer(typed: TypedExpression) -> bool:
    kind = typed.type
    return isinstance(kind, Quantity | SignalType) and kind.is_integer and kind.dimension.is_pure


def _formula(
    span: Span,
    formula: Formula,
    evidence: DomainEvidence | None,
    parts: Sequence[TypedExpression],
    numbers: tuple[NumberBinding, ...],
) -> TypedExpression:
    domain = evidence.domain if evidence else "scene"
    signals = distinct(signal for part in parts for signal in part.signals)
    return TypedExpression(
        span,
        FormulaType(domain),
        formula=formula,
        evidence=evidence,
        signals=signals,
        numbers=numbers,
        random=any(part.random for part in parts),
    )


def infer_not(checker: Checker, node: ast.NotExpression, context: Context) -> TypedExpression:
    """`not f` of a formula."""
    operand = infer_operand(checker, node.operand, context, "`not`")
    if operand.formula is None:
        return unknown(node.span)
    return replace(operand, span=node.span, formula=Not(operand.formula))


def infer_logic(checker: Checker, node: ast.Logic, context: Context) -> TypedExpression:
    """`and`, `or`, `implies`, `iff`, `xor`."""
    what = f"`{node.word}`"
    typed = [checker.infer(operand, context) for operand in node.operands]
    turned = turned_at_least(checker, node, typed)
    if turned is not None:
        return turned
    parts = [as_formula(checker, each, what) for each in typed]
    formulas = [part.formula for part in parts if part.formula is not None]
    if len(formulas) < len(parts):
        return unknown(node.span)
    return _joined(checker, node.span, lambda: compound(node.word, formulas), parts)


def _joined(
    checker: Checker, span: Span, make: Any, parts: Sequence[TypedExpression]
) -> TypedExpression:
    evidence = common_domain(checker, parts)
    if isinstance(evidence, TypedExpression):
        return evidence
    numbers = distinct(number for part in parts for number in part.numbers)
    return _formula(span, make(), evidence, parts, numbers)


def infer_temporal(checker: Checker, node: ast.Temporal, context: Context) -> TypedExpression:
    """`always[a, b] p` and its kin."""
    operand = infer_operand(checker, node.operand, context, f"`{node.word}`")
    ends = interval_ends(checker, node.interval, context)
    if operand.formula is None or ends is None:
        return without_operand(checker, node, ends)
    interval = interval_of(checker, node, ends, operand.evidence)
    if isinstance(interval, TypedExpression):
        return interval
    formula = compound(node.word, [operand.formula], interval)
    return replace(operand, span=node.span, formula=formula)


def infer_binding(checker: Checker, node: ast.Binding, context: Context) -> TypedExpression:
    """`left until[a, b] right` and `since`."""
    sides = (node.left, node.right)
    parts = [infer_operand(checker, side, context, f"`{node.word}`") for side in sides]
    ends = interval_ends(checker, node.interval, context)
    if ends is None or any(part.formula is None for part in parts):
        return without_operand(checker, node, ends)
    evidence = common_domain(checker, parts)
    if isinstance(evidence, TypedExpression):
        return evidence
    interval = interval_of(checker, node, ends, evidence)
    if isinstance(interval, TypedExpression):
        return interval
    sides_read = [part.formula for part in parts if part.formula is not None]
    return _joined(checker, node.span, lambda: compound(node.word, sides_read, interval), parts)


def infer_operand(
    checker: Checker, node: ast.Expression, context: Context, what: str
) -> TypedExpression:
    """A formula; anything else is reported and unknown."""
    return as_formula(checker, checker.infer(node, context), what)


def as_formula(checker: Checker, typed: TypedExpression, what: str) -> TypedExpression:
    """The expression as a formula: one already, or a flag."""
    if typed.is_unknown or isinstance(typed.type, FormulaType):
        return typed
    if isinstance(typed.type, BooleanType):
        if isinstance(typed.value, Reference):
            return replace(typed, type=FormulaType("scene"), **_flag(typed.value))
        return replace(typed, type=FormulaType("scene"))
    help_ = (
        (f"compare it with something, as in `> 0{_written_unit(typed.type.dimension)}`",)
        if isinstance(typed.type, Quantity | SignalType)
        else ()
    )
    return checker.report(
        Code.FORMULA_EXPECTED, typed.span, what=what, found=typed.type, help=help_
    )


def _written_unit(dimension: Dimension) -> str:
    """As it is written after a number: `10m/s`, `10/m`."""
    return dimension.unit.removeprefix("1")


def _flag(value: Reference) -> dict[str, Any]:
    # A flag counts as 1 or 0 where the pipeline computes with it.
    formula = Comparison(">", Variable(value.name), Constant(0.5))
    return {"formula": formula, "numbers": (NumberBinding(value.name, value),)}


def interval_ends(
    checker: Checker, interval: ast.IntervalExpression | None, context: Context
) -> tuple[TypedExpression, ...] | None:
    """The two ends of an interval, constant numbers; () without an interval."""
    if interval is None:
        return ()
    ends = [checker.infer(end, context) for end in (interval.low, interval.high)]
    if any(end.is_unknown for end in ends):
        return None
    for end in ends:
        if not isinstance(end.type, Quantity):
            what = "the end of an interval"
            checker.report(
                Code.WRONG_TYPE, end.span, what=what, expected="a number", found=end.type
            )
            return None
        if end.constant is None:
            expected = "the same in every scene"
            checker.report(
                Code.MUST_NOT_BE_RANDOM, end.span, what="the end of an interval", expected=expected
            )
            return None
    return tuple(ends)


def interval_of(
    checker: Checker,
    node: ast.Temporal | ast.MeasureExpression | ast.Binding,
    ends: tuple[TypedExpression, ...],
    evidence: DomainEvidence | None,
) -> Interval | TypedExpression | None:
    """The interval in the unit of the formula's domain; unknown, reported, where it is not."""
    if evidence is None:
        help_ = f"leave out `{node.word}`; `expect` evaluates it over the drive"
        return checker.report(
            Code.TEMPORAL_OVER_CONSTANTS, node.word_span, word=node.word, help=help_
        )
    if not ends:
        return None
    expected = LENGTH if evidence.domain == "road" else TIME
    wrong = []
    for end in ends:
        assert isinstance(end.type, Quantity)
        if end.type.fits_any or end.type.dimension == expected:
            continue
        if end.type.bare:
            return unit_missing(checker, end, expected)
        wrong.append(end)
    if wrong:
        return _wrong_unit(checker, wrong, evidence)
    return _in_order(checker, ends)


def without_operand(
    checker: Checker,
    node: ast.Temporal | ast.MeasureExpression | ast.Binding,
    ends: tuple[TypedExpression, ...] | None,
) -> TypedExpression:
    """What is left where an operand was refused: the interval may be wrong as well."""
    if ends and len({dimension_of(end) for end in ends}) == 1:
        _in_order(checker, ends)
    return unknown(node.span)


def _in_order(checker: Checker, ends: tuple[TypedExpression, ...]) -> Interval | TypedExpression:
    low, high = (end.constant for end in ends)
    assert low is not None
    assert high is not None
    if not 0 <= low <= high or math.isinf(low):
        span = ends[0].span.to(ends[1].span)
        lo, hi = (end.span.text for end in ends)
        help_, meant = interval_help(low, high, lo, hi)
        fixes = [Fix(span, meant[1:-1])] if meant else ()
        return checker.report(Code.INVALID_INTERVAL, span, help=help_, fixes=fixes, lo=lo, hi=hi)
    return Interval(low, high)


def _wrong_unit(
    checker: Checker, wrong: Sequence[TypedExpression], evidence: DomainEvidence
) -> TypedExpression:
    from ...diagnostics import Label

    road = evidence.domain == "road"
    assert isinstance(wrong[0].type, Quantity)
    return checker.report(
        Code.WRONG_INTERVAL_UNIT,
        wrong[0].span.to(wrong[-1].span),
        labels=[Label(evidence.span, "the signal is over " + ("the road" if road else "time"))],
        found=wrong[0].type.dimension,
        signal=evidence.text,
        domain="arc length along the road" if road else "time",
        help="write meters, as in `[0m, 50m]`" if road else "write seconds, as in `[0s, 5s]`",
    )  # fmt: skip


def condition_of(node: ast.Expression, typed: TypedExpression) -> Condition:
    """The IR of a formula; its text is the same however the formula is laid out."""
    domain = typed.evidence.domain if typed.evidence else "scene"
    formula = typed.formula if typed.formula is not None else Truth(True)
    return Condition(one_line(node), formula, domain, typed.signals, typed.numbers)
