"""Requirements and expectations."""

from __future__ import annotations

from dataclasses import replace

from ...diagnostics import Code
from ...ir import scenario as ir
from ...plugins.kinds import Monitor
from ...syntax.printing.nodes import one_line
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..infer.blocks import lower_call
from ..infer.formulas import as_formula, condition_of
from ..infer.kinds import find_kind
from ..infer.statement_spec import StatementSpec
from ..infer.triviality import warn_if_trivial
from ..names.program import Declaration
from ..types.expression_types import TypedExpression
from .evaluation import lower_evaluation


def lower_constraint(
    checker: Checker, spec: StatementSpec, declaration: Declaration
) -> ir.ScenarioConstraint | None:
    """`require` or `expect`: a formula or the call of a monitor."""
    statement = declaration.statement
    assert isinstance(statement, ast.Constraint)
    name, word = statement.name.text, statement.word
    # What is judged while driving does not have to be there before the name itself.
    context = Context(user=name, place=name, drive_time=False)
    if statement.kind is not None:
        return _judged(checker, statement, statement.kind, context)
    if statement.formula is None:
        return None
    typed = as_formula(checker, checker.infer(statement.formula, context), f"`{word}`")
    if typed.is_unknown:
        return None
    evidence = typed.evidence
    if word == "require" and evidence is not None and evidence.domain == "drive":
        help_ = (
            f"`{evidence.text}` is known only when the scene is driven: write `expect {name}: ...`",
            "positions at the start can be compared: `lead.start - ego.start > 10m`",
        )
        checker.report(
            Code.WRONG_DOMAIN, evidence.span, what="`require`", expected="roads and placement",
            found="the drive", help=help_,
        )  # fmt: skip
        return None
    evaluation = lower_evaluation(checker, spec, statement, typed)
    _warn_if_at_start(checker, statement, statement.formula, typed)
    warn_if_trivial(checker, statement, typed)
    if evaluation is None:
        return None
    condition = condition_of(statement.formula, typed)
    if statement.block is not None and not evaluation.is_plain:
        options = statement.block.options
        written = ", ".join(f"{item.key.text}: {one_line(item.value)}" for item in options)
        text = f"{condition.text} {{ {written} }}"
        place = next((i.value.span for i in options if i.key.text == "semantics"), None)
        condition = replace(condition, text=text, evaluation=evaluation, semantics_span=place)
    return ir.ScenarioConstraint(name, condition, statement.span)


def _warn_if_at_start(
    checker: Checker, statement: ast.Constraint, written: ast.Expression, typed: TypedExpression
) -> None:
    """RL295: signals without an operator that says where or when."""
    if typed.evidence is None or typed.formula is None or typed.formula.temporal:
        return
    name, text = statement.name.text, one_line(written)
    operand = text if isinstance(written, ast.GroupExpression) else f"({text})"
    checker.report(
        Code.JUDGED_AT_START,
        written.span,
        name=name,
        what=typed.evidence.domain,
        help=f"write `always {operand}`, or `eventually {operand}`",
    )


def _judged(
    checker: Checker, statement: ast.Constraint, kind: ast.KindName, context: Context
) -> ir.ScenarioConstraint | None:
    found = find_kind(checker, "monitor", kind.text, kind.span)
    if found is None:
        return None
    owner = f"`{kind.text}`"
    call = lower_call(
        checker, found, statement.block, (), context, owner, kind.span, statement.span
    )
    assert issubclass(found.kind, Monitor)
    if statement.word == "require" and found.kind.domain == "drive":
        help_ = f"`expect {statement.name.text} with {kind.text}` judges the drive"
        checker.report(
            Code.WRONG_DOMAIN,
            kind.span,
            what="`require`",
            expected="roads and placement",
            found="the drive",
            help=help_,
        )
        return None
    return (
        None if call is None else ir.ScenarioConstraint(statement.name.text, call, statement.span)
    )
