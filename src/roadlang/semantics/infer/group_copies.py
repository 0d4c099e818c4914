"""`cars[0]`: one of the copies of a group."""

from __future__ import annotations

from dataclasses import replace

from ...diagnostics import Code
from ...ir.values import Entity
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..types.expression_types import DeclaredType, TypedExpression, unknown


def infer_numbered(checker: Checker, node: ast.Numbered, context: Context) -> TypedExpression:
    """The copy of that number, counted from 0, of a group of agents or objects."""
    group = checker.infer(node.of, context)
    if group.is_unknown:
        return unknown(node.span)
    entity, place = group.value, node.number.span
    role = group.type.role if isinstance(group.type, DeclaredType) else ""
    if not isinstance(entity, Entity) or role not in ("agent", "object"):
        what, expected = "a name with an index in brackets", "a group of agents or objects"
        return checker.report(
            Code.WRONG_TYPE, node.of.span, what=what, expected=expected, found=group.type
        )
    count = written_count(checker, entity.name)
    if count is None:
        help_ = f"write `{entity.name}`, or declare it with `count:`"
        return _refused(checker, node, f"`{entity.name}` is not a group", help_)
    number = node.number.value
    if node.number.unit or not number.is_integer():
        help_ = "copies are counted from 0 without a unit: `[0]`, `[1]`, ..."
        return _refused(checker, node, f"`{place.text}` is not the number of a copy", help_)
    most = checker.infer(count, context).constant
    if most is not None and number >= most:
        last = f"copies are counted from 0: the last is `{entity.name}[{int(most) - 1}]`"
        help_ = last if most else "it has no copies"
        return _refused(checker, node, f"`{entity.name}` has {int(most)} copies", help_)
    return replace(group, span=node.span, value=replace(entity, copy=int(number) + 1))


def group_of(expression: ast.Expression) -> ast.Expression:
    """What a number in brackets stands after; of anything else, the expression itself."""
    return expression.of if isinstance(expression, ast.Numbered) else expression


def written_count(checker: Checker, name: str) -> ast.Expression | None:
    """The `count` of an agent or object; None of what is no group."""
    statement = checker.program.declarations[name].statement
    block = statement.block if isinstance(statement, ast.Actor) else None
    options = () if block is None else block.options
    return next((option.value for option in options if option.key.text == "count"), None)


def _refused(checker: Checker, node: ast.Numbered, reason: str, help_: str) -> TypedExpression:
    text = " ".join(node.span.text.split())
    return checker.report(Code.NO_SUCH_COPY, node.span, copy=text, reason=reason, help=help_)
