"""`count[0, 10] (p) <= 3`: from the comparison as written to formulas, and what is refused."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from ...diagnostics import Code, Diagnostic, Fix, Span, diagnose
from ...syntax.tree import nodes as ast
from ..formula import formulas as f
from ..formula.interval import Interval
from ..formula.measures import MIRRORED


class WrittenMeasure(NamedTuple):
    """`measure op number`."""

    measure: ast.MeasureExpression
    op: str
    number: ast.Expression


def measure_in(node: ast.Expression) -> ast.MeasureExpression | None:
    """The count or duration that an operand is, parentheses or not."""
    while isinstance(node, ast.GroupExpression):
        node = node.inner
    return node if isinstance(node, ast.MeasureExpression) else None


def written_measures(node: ast.ComparisonExpression) -> list[WrittenMeasure] | Diagnostic:
    """Each comparison of a chain with the measure on its left."""
    found = []
    pairs = zip(node.operands, node.operands[1:], strict=False)
    for op, (left, right) in zip(node.operators, pairs, strict=True):
        measure, other = measure_in(left), measure_in(right)
        if measure is not None and other is None:
            found.append(WrittenMeasure(measure, op, right))
        elif other is not None and measure is None:
            found.append(WrittenMeasure(other, MIRRORED.get(op, op), left))
        elif measure is not None:
            return not_a_constant(measure, right.span)
        else:
            written = next(filter(None, map(measure_in, node.operands)))
            return not_compared(written)
    return found


def measured_formula(
    word: str, interval: Interval | None, operand: f.Formula, op: str, amount: float
) -> f.Formula:
    """`word[interval] (operand) op amount`; `==` and `!=` by two comparisons."""
    kind = f.COMPOUNDS[word]
    assert issubclass(kind, f.Measured)
    match op:
        case "==":
            join: type[f.LogicalJunction] = f.And
            return join(tuple(kind(interval, operand, each, amount) for each in (">=", "<=")))
        case "!=":
            return f.Or(tuple(kind(interval, operand, each, amount) for each in ("<", ">")))
        case "<" | "<=" | ">" | ">=":
            return kind(interval, operand, op, amount)
    raise ValueError(op)


def all_of(formulas: Iterable[f.Formula]) -> f.Formula:
    """What a chain of comparisons says."""
    parts = tuple(formulas)
    return parts[0] if len(parts) == 1 else f.And(parts)


def not_compared(measure: ast.MeasureExpression) -> Diagnostic:
    """RL329: a count or duration that is no side of a comparison."""
    text = " ".join(measure.span.text.split())
    example = "< 3" if measure.word == "count" else "< 2s"
    return diagnose(
        Code.MEASURE_COMPARISON,
        measure.span,
        help=f"compare it with a number: `{text} {example}`",
        word=measure.word,
        problem="is not compared with a number",
    )


def not_a_constant(measure: ast.MeasureExpression, span: Span) -> Diagnostic:
    """RL329: the other side is no number, or one that changes."""
    text = " ".join(span.text.split())
    return diagnose(
        Code.MEASURE_COMPARISON,
        span,
        help="write a number that is the same in every scene and at every sample",
        word=measure.word,
        problem=f"is compared with `{text}`, which is not a constant",
    )


def count_with_unit(number: ast.NumberLiteral) -> Diagnostic:
    """RL329: a count is a number of samples."""
    help_ = "a count is a number of samples; use `duration` for how long a formula holds"
    return diagnose(
        Code.MEASURE_COMPARISON,
        number.span,
        help=help_,
        fixes=(Fix(number.span, number.digits),),
        word="count",
        problem=f"is compared with `{number.span.text}`, which has a unit",
    )
