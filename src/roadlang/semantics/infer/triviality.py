"""Requirements that cannot fail, or cannot hold, whatever is drawn."""

from __future__ import annotations

from ...diagnostics import Code
from ...stl.evaluate.static_truth import static_truth
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..types.expression_types import TypedExpression


def warn_if_trivial(checker: Checker, statement: ast.Constraint, typed: TypedExpression) -> None:
    """RL290 where the bounds of the numbers in a formula decide it."""
    assert typed.formula is not None
    bounds = {number.variable: checker.bounds_of(number.value) for number in typed.numbers}
    truth = static_truth(typed.formula, bounds)
    if truth.possible and not truth.certain:
        return
    checker.report(
        Code.TRIVIAL_REQUIREMENT,
        typed.span,
        word=statement.word,
        name=statement.name.text,
        verdict="always holds" if truth.certain else "can never hold",
    )
