"""Requirements that cannot fail, or cannot hold, whatever is drawn."""

from __future__ import annotations

from ...diagnostics import Code
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..types.expression_types import TypedExpression


def warn_if_trivial(checker: Checker, statement: ast.Constraint, typed: TypedExpression) -> None:
    """RL290 where the bounds of the numbers in a formula decide it."""
    if statement.formula is None:
        return
    outcome = _outcome(checker, statement.formula)
    if outcome is None:
        return
    verdict = "always holds" if outcome else "can never hold"
    checker.report(
        Code.TRIVIAL_REQUIREMENT,
        typed.span,
        word=statement.word,
        name=statement.name.text,
        verdict=verdict,
    )


def _outcome(checker: Checker, node: ast.Expression) -> bool | None:
    """True or False where that is what a formula always is."""
    match node:
        case ast.Boolean(value):
            return value
        case ast.Group(inner):
            return _outcome(checker, inner)
        case ast.Not(operand):
            inside = _outcome(checker, operand)
            return None if inside is None else not inside
        case ast.Temporal():
            return _outcome(checker, node.operand)
        case ast.Logic("and", operands):
            return _all([_outcome(checker, operand) for operand in operands])
        case ast.Logic("or", operands):
            return _any([_outcome(checker, operand) for operand in operands])
        case ast.Logic("implies", (left, right)):
            first = _outcome(checker, left)
            return _any([None if first is None else not first, _outcome(checker, right)])
        case ast.Comparison():
            return _comparison(checker, node)
    return None


def _all(parts: list[bool | None]) -> bool | None:
    if False in parts:
        return False
    return True if all(part is True for part in parts) else None


def _any(parts: list[bool | None]) -> bool | None:
    if True in parts:
        return True
    return False if all(part is False for part in parts) else None


def _comparison(checker: Checker, node: ast.Comparison) -> bool | None:
    bounds = [checker.bounds.get(id(operand)) for operand in node.operands]
    pairs = zip(node.operators, bounds, bounds[1:], strict=False)
    return _all([_decided(op, left, right) for op, left, right in pairs])


def _decided(
    op: str, left: tuple[float, float] | None, right: tuple[float, float] | None
) -> bool | None:
    if left is None or right is None or op in ("==", "!="):
        return None
    if op in (">", ">="):
        op, left, right = {">": "<", ">=": "<="}[op], right, left
    if op == "<":
        return True if left[1] < right[0] else False if left[0] >= right[1] else None
    return True if left[1] <= right[0] else False if left[0] > right[1] else None
