"""`when:` and `while:` of a pass: conditions on the drive that look back only."""

from __future__ import annotations

from dataclasses import replace

from ...diagnostics import Code, Span
from ...ir.dimension import TIME
from ...stl.formula.formulas import COMPOUNDS, TemporalOperator
from ...syntax.operators import BY_WORD
from ...syntax.tree import nodes as ast
from ...syntax.tree.walk import walk
from ..checker import Checker
from ..context import Context
from ..types.expression_types import BooleanType, FormulaType, Quantity, TypedExpression
from .formulas import condition_of


def check_condition(
    checker: Checker, value: ast.Expression, context: Context
) -> TypedExpression | None:
    """A formula over the drive that looks back only."""
    option = context.place.rpartition("/")[2]
    what = f"`{option}`"
    typed = checker.infer(value, replace(context, drive_time=True))
    if typed.is_unknown:
        return None
    if not isinstance(typed.type, FormulaType | BooleanType):
        help_ = _time_help(typed, option)
        checker.report(
            Code.WRONG_TYPE, typed.span,
            what=what, expected="a condition", found=typed.type, help=help_,
        )  # fmt: skip
        return None
    if typed.evidence is not None and typed.evidence.domain == "road":
        place = typed.evidence
        checker.report(
            Code.WRONG_DOMAIN, place.span, what=what, expected="the drive", found="the road"
        )
        return None
    if not _only_past(checker, value, typed, option):
        return None
    return replace(typed, value=condition_of(value, typed))


def _time_help(typed: TypedExpression, option: str) -> tuple[str, ...]:
    """How a time is written as a condition: `when: 3s`."""
    if not isinstance(typed.type, Quantity) or typed.type.dimension != TIME:
        return ()
    return (f"write `time {'<' if option == 'while' else '>'} {typed.span.text}`",)


def _only_past(
    checker: Checker, expression: ast.Expression, typed: TypedExpression, option: str
) -> bool:
    """False, reported, where a formula looks ahead."""
    written = next(filter(_looks_ahead, (node for node, _ in walk(expression))), None)
    if isinstance(written, ast.Temporal | ast.MeasureExpression | ast.Binding):
        _report_future(checker, written.word, written.word_span, option)
        return False
    # A `let` that the formula names may look ahead as well.
    parts = typed.formula.walk() if typed.formula is not None else ()
    ahead = (part for part in parts if isinstance(part, TemporalOperator) and not part.past)
    if (part := next(ahead, None)) is not None:
        _report_future(checker, part.word, typed.span, option)
        return False
    return True


def _looks_ahead(node: ast.SyntaxNode) -> bool:
    if not isinstance(node, ast.Temporal | ast.MeasureExpression | ast.Binding):
        return False
    operator = COMPOUNDS[node.word]
    return issubclass(operator, TemporalOperator) and not operator.past


def _report_future(checker: Checker, word: str, span: Span, option: str) -> None:
    mirror = BY_WORD[word].mirror
    help_ = f"`{mirror}` looks back instead" if mirror else "`once` and `historically` look back"
    checker.report(Code.FUTURE_OPERATOR_IN_WHEN, span, word=word, option=option, help=help_)
