"""Arithmetic on numbers and signals: dimensions, constants folded, terms for formulas."""

from __future__ import annotations

import math
import operator as ops
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from ...diagnostics import Code, Label, Span
from ...ir.dimension import PURE, Dimension
from ...ir.values import ConstantValue, NumberBinding, Operation, Value
from ...stl.evaluate.interval_arithmetic import arithmetic, of_function
from ...stl.formula import terms as t
from ...syntax.tree import nodes as ast
from ..checker import Checker
from .dimensions import common_dimension, dimension_of
from .expression_types import DomainEvidence, Quantity, SignalType, TypedExpression, unknown
from .number_terms import distinct, term_of

_OPERATIONS = {"+": ops.add, "-": ops.sub, "*": ops.mul, "/": ops.truediv, "^": ops.pow}


def signal_negation(operand: TypedExpression, span: Span) -> TypedExpression:
    """`-signal`."""
    assert operand.term is not None
    return replace(operand, span=span, term=t.Negate(operand.term))


def signal_arithmetic(
    checker: Checker, node: ast.ArithmeticExpression, left: TypedExpression, right: TypedExpression
) -> TypedExpression:
    """`left operator right` of two numbers, or with a signal on at least one side."""
    dimension = _dimension(checker, node, left, right)
    if dimension is None:
        return unknown(node.span)
    if node.operator == "/" and right.constant == 0:
        return checker.report(Code.NOT_FINITE, node.right.span, what="a number divided by 0")
    both = (left, right)
    if any(isinstance(side.type, SignalType) for side in both):
        return _of_signals(checker, node, both, dimension)
    kinds = [side.type for side in both if isinstance(side.type, Quantity)]
    kind = Quantity(
        dimension,
        fits_any=all(k.fits_any for k in kinds),
        is_integer=node.operator in "+-*" and all(k.is_integer for k in kinds),
    )
    value = _folded(checker, node, left, right, dimension)
    if value is None:
        return unknown(node.span)
    random = left.random or right.random
    bounds = arithmetic(node.operator, left.bounds, right.bounds)
    if isinstance(value, ConstantValue):
        bounds = (value.value, value.value)
    return TypedExpression(node.span, kind, value, random=random, bounds=bounds)


def _dimension(
    checker: Checker, node: ast.ArithmeticExpression, left: TypedExpression, right: TypedExpression
) -> Dimension | None:
    if node.operator in "+-":
        return common_dimension(checker, (left, right), "added" if node.operator == "+" else
                                "subtracted")  # fmt: skip
    if node.operator == "*":
        return dimension_of(left) * dimension_of(right)
    if node.operator == "/":
        return dimension_of(left) / dimension_of(right)
    exponent = right.constant
    if not dimension_of(right).is_pure:
        checker.report(
            Code.WRONG_DIMENSION,
            right.span,
            what="an exponent",
            expected="a dimensionless number",
            found=right.type,
        )
        return None
    if dimension_of(left).is_pure:
        return PURE
    if exponent is None:
        expected = "the same in every scene, since the unit depends on it"
        checker.report(Code.MUST_NOT_BE_RANDOM, right.span, what="an exponent", expected=expected)
        return None
    return dimension_of(left) ** exponent


def _folded(
    checker: Checker,
    node: ast.ArithmeticExpression,
    left: TypedExpression,
    right: TypedExpression,
    dimension: Dimension,
) -> Value | None:
    a, b = left.value, right.value
    assert a is not None
    assert b is not None
    if not (isinstance(a, ConstantValue) and isinstance(b, ConstantValue)):
        return Operation(node.operator, (a, b))
    number = _computed(node.operator, a.value, b.value)
    if number is None:
        checker.report(Code.NOT_FINITE, node.span, what="this")
        return None
    return ConstantValue(number, dimension)


def _computed(operator: str, a: float, b: float) -> float | None:
    try:
        number: Any = _OPERATIONS[operator](a, b)
    except (OverflowError, ZeroDivisionError):
        return None
    if isinstance(number, complex) or math.isnan(number):
        return None
    infinite = math.isinf(number) and not (math.isinf(a) or math.isinf(b))
    return None if infinite else float(number)


def _of_signals(
    checker: Checker,
    node: ast.ArithmeticExpression,
    sides: tuple[TypedExpression, TypedExpression],
    dimension: Dimension,
) -> TypedExpression:
    evidence = common_domain(checker, sides)
    if isinstance(evidence, TypedExpression):
        return evidence
    assert evidence is not None
    terms, numbers = terms_of(sides)
    signals = distinct(signal for side in sides for signal in side.signals)
    term = t.Arithmetic(node.operator, terms[0], terms[1])  # type: ignore[arg-type]
    kind = SignalType(evidence.domain, dimension)
    return TypedExpression(
        node.span, kind, term=term, evidence=evidence, signals=signals, numbers=numbers
    )


def terms_of(sides: Sequence[TypedExpression]) -> tuple[list[Any], tuple[NumberBinding, ...]]:
    """The terms of numbers and signals, and the bindings of the numbers among them."""
    terms: list[Any] = []
    numbers: list[NumberBinding] = []
    for side in sides:
        if side.term is not None:
            terms.append(side.term)
            numbers.extend(side.numbers)
        elif side.constant is not None:
            terms.append(_constant(side.constant))
        else:
            assert side.value is not None
            term, found = term_of(side.value)
            terms.append(term)
            numbers.extend(found)
    return terms, distinct(numbers)


def _constant(value: float) -> Any:
    return t.Constant(value)


def common_domain(
    checker: Checker, parts: Sequence[TypedExpression]
) -> DomainEvidence | TypedExpression | None:
    """The domain that signals and formulas share; None where all are numbers.

    Unknown, reported with both places, where a road signal meets a drive signal.
    """
    found: DomainEvidence | None = None
    for part in parts:
        if part.evidence is None:
            continue
        if found is not None and part.evidence.domain != found.domain:
            labels = [Label(found.span, _what(found))]
            return checker.report(
                Code.MIXED_DOMAINS, part.evidence.span, labels=labels, one=found.text,
                other=part.evidence.text, one_domain=_domain(found),
                other_domain=_domain(part.evidence),
                help="write one `expect` about the road and another one about the drive",
            )  # fmt: skip
        found = found or part.evidence
    return found


def _domain(evidence: DomainEvidence) -> str:
    return "the road" if evidence.domain == "road" else "the drive"


def _what(evidence: DomainEvidence) -> str:
    return f"a signal over {_domain(evidence)}"


def of_functions(
    name: str, arguments: Sequence[TypedExpression], span: Span, dimension: Dimension
) -> TypedExpression:
    """`abs`, `min` or `max` of numbers alone."""
    values = tuple(argument.value for argument in arguments if argument.value is not None)
    bounds = of_function(name, [argument.bounds for argument in arguments])
    constants = [argument.constant for argument in arguments]
    value: Value = Operation(name, values)
    if all(constant is not None for constant in constants):
        value = ConstantValue(bounds[0], dimension)
    random = any(argument.random for argument in arguments)
    kind = Quantity(dimension)
    return TypedExpression(span, kind, value, random=random, bounds=bounds)


def signal_of_functions(
    checker: Checker,
    name: str,
    arguments: Sequence[TypedExpression],
    span: Span,
    dimension: Dimension,
) -> TypedExpression:
    """`abs`, `min` or `max` where at least one argument is a signal."""
    evidence = common_domain(checker, arguments)
    if evidence is None or isinstance(evidence, TypedExpression):
        return unknown(span)
    terms, numbers = terms_of(arguments)
    return TypedExpression(
        span,
        SignalType(evidence.domain, dimension),
        term=t.Apply(name, tuple(terms)),  # type: ignore[arg-type]
        evidence=evidence,
        signals=distinct(signal for argument in arguments for signal in argument.signals),
        numbers=numbers,
    )
