"""Formulas with the bindings of their variables; which of them look ahead."""

from __future__ import annotations

import re

from ...diagnostics import Code
from ...ir.values import Condition
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..types.expression_types import Typed

_COMMENT = re.compile(r"#[^\n]*")
_FUTURE = ("always", "eventually", "until")


def condition_of(typed: Typed) -> Condition:
    """The IR of a formula."""
    from ...stl import Truth

    domain = typed.evidence.domain if typed.evidence else "scene"
    formula = typed.formula if typed.formula is not None else Truth(True)
    # A color in a formula cannot be: a `#` begins a comment here.
    text = " ".join(_COMMENT.sub(" ", typed.span.text).split())
    return Condition(text, formula, domain, typed.signals, typed.numbers)


def only_past(checker: Checker, expression: ast.Expression, typed: Typed) -> bool:
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
