"""`when:` of a pass: a condition on the drive that looks back only."""

from __future__ import annotations

from dataclasses import replace

from ...diagnostics import Code
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..types.expression_types import BooleanType, FormulaType, TypedExpression
from .formulas import condition_of

_FUTURE = ("always", "eventually", "until")


def check_condition(
    checker: Checker, value: ast.Expression, context: Context
) -> TypedExpression | None:
    """`when:` a formula over the drive that looks back only."""
    typed = checker.infer(value, replace(context, drive_time=True))
    if typed.is_unknown:
        return None
    if not isinstance(typed.type, FormulaType | BooleanType):
        checker.report(
            Code.WRONG_TYPE, typed.span, what="`when`", expected="a condition", found=typed.type
        )
        return None
    if typed.evidence is not None and typed.evidence.domain == "road":
        place = typed.evidence
        checker.report(
            Code.WRONG_DOMAIN, place.span, what="`when`", expected="the drive", found="the road"
        )
        return None
    if not _only_past(checker, value, typed):
        return None
    return replace(typed, value=condition_of(typed))


def _only_past(checker: Checker, expression: ast.Expression, typed: TypedExpression) -> bool:
    """False, reported, where a formula looks ahead."""
    from ...stl import Always, Eventually, Until

    written = _future_word(expression)
    if written is not None:
        checker.report(
            Code.FUTURE_OPERATOR_IN_WHEN,
            written.word_span,
            word=written.word,
            help=_backwards(written.word),
        )
        return False
    formula = typed.formula
    ahead = (Always, Eventually, Until)
    if formula is not None and any(isinstance(part, ahead) for part in formula.walk()):
        part = next(part for part in formula.walk() if isinstance(part, ahead))
        word = type(part).__name__.lower()
        checker.report(Code.FUTURE_OPERATOR_IN_WHEN, typed.span, word=word, help=_backwards(word))
        return False
    return True


def _backwards(word: str) -> str:
    past = {"always": "historically", "eventually": "once", "until": "since"}[word]
    return f"`{past}` looks back instead"


def _future_word(expression: ast.Expression) -> ast.Temporal | ast.Binding | None:
    if isinstance(expression, ast.Temporal | ast.Binding) and expression.word in _FUTURE:
        return expression
    parts: tuple[ast.Expression, ...] = ()
    match expression:
        case ast.Temporal() | ast.Not():
            parts = (expression.operand,)
        case ast.Group():
            parts = (expression.inner,)
        case ast.Binding():
            parts = (expression.left, expression.right)
        case ast.Logic():
            parts = expression.operands
    found = (_future_word(part) for part in parts)
    return next((part for part in found if part is not None), None)
