"""`speed => 2m/s`: the arrow of the literature where a comparison is meant."""

from __future__ import annotations

from collections.abc import Sequence

from ...diagnostics import Code, Fix
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..types.expression_types import Quantity, SignalType, TypedExpression

_ARROW = "=>"


def turned_at_least(
    checker: Checker, node: ast.Logic, operands: Sequence[TypedExpression]
) -> TypedExpression | None:
    """RL234 for `=>` between two numbers or signals; None for everything else."""
    if not all(isinstance(each.type, Quantity | SignalType) for each in operands):
        return None
    source, end = node.span.source, node.operands[1].span.start
    start = source.text.find(_ARROW, node.operands[0].span.end, end)
    if start < 0:
        return None
    sign = source.span(start, start + len(_ARROW))
    return checker.report(
        Code.FORMULA_EXPECTED,
        sign,
        what=f"`{node.word}`",
        found=operands[0].type,
        help=f"`{_ARROW}` is `{node.word}`; at least is written `>=`",
        fixes=[Fix(sign, ">=")],
    )
