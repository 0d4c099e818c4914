"""Requirements, expectations, the world, plans and outputs."""

from __future__ import annotations

from ...diagnostics import Code, Label, Span
from ...ir import scenario as ir
from ...ir.values import PassCall, Value
from ...plugins.kinds import Monitor
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..infer.blocks import lower_call, lower_options, refuse_passes
from ..infer.conditions import condition_of
from ..infer.formulas import as_formula
from ..infer.kinds import find_kind, spoken
from ..infer.statements import STATEMENTS
from ..infer.triviality import warn_if_trivial
from ..names.program import Declaration, Placed

_DEFAULTS = {"sample": "random", "simulate": "builtin", "falsify": "random"}


def lower_constraint(checker: Checker, declaration: Declaration) -> ir.Constraint | None:
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
        help_ = f"`expect {name}: ...` judges the drive"
        checker.report(
            Code.WRONG_DOMAIN, evidence.span, what="`require`", due="roads and placement",
            found="the drive", help=help_,
        )  # fmt: skip
        return None
    warn_if_trivial(checker, statement, typed)
    return ir.Constraint(name, condition_of(typed), statement.span)


def _judged(
    checker: Checker, statement: ast.Constraint, kind: ast.Kind, context: Context
) -> ir.Constraint | None:
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
            due="roads and placement",
            found="the drive",
            help=help_,
        )
        return None
    return None if call is None else ir.Constraint(statement.name.text, call, statement.span)


def lower_world(checker: Checker, placed: Placed) -> tuple[tuple[str, Value], ...]:
    statement = placed.statement
    assert isinstance(statement, ast.World)
    context = Context(user="world", place="world")
    schema = STATEMENTS["world"].schema
    bound = lower_options(checker, "world", statement.block, schema, context, statement.span)
    refuse_passes(checker, "world", statement.block.passes if statement.block else ())
    return bound.values


def lower_plan(checker: Checker, placed: Placed) -> PassCall | None:
    """`sample`, `simulate`, `falsify`."""
    statement = placed.statement
    assert isinstance(statement, ast.Plan)
    word = statement.word
    keyword = statement.span.source.span(statement.span.start, statement.span.start + len(word))
    name = statement.kind.text if statement.kind else _DEFAULTS[word]
    span = statement.kind.span if statement.kind else keyword
    return _run_call(checker, word, name, span, statement, place=word)


def lower_emit(checker: Checker, placed: Placed, number: int) -> PassCall | None:
    statement = placed.statement
    assert isinstance(statement, ast.Emit)
    kind = statement.kind
    return _run_call(checker, "emit", kind.text, kind.span, statement, place=f"emit {number}")


def _run_call(
    checker: Checker,
    verb: str,
    name: str,
    span: Span,
    statement: ast.Plan | ast.Emit,
    place: str,
) -> PassCall | None:
    """A call whose options belong to the run: they cannot differ between scenes."""
    found = find_kind(checker, verb, name, span)
    if found is None:
        return None
    context = Context(user=place, place=place)
    owner = f"`{spoken(verb, name)}`"
    block = statement.block
    call = lower_call(checker, found, block, (), context, owner, span, statement.span)
    for option in block.options if call is not None and block is not None else ():
        if is_random(checker, call, option.key.text):
            what = f"`{option.key.text}`"
            checker.report(
                Code.MUST_NOT_BE_RANDOM, option.value.span, what=what, due="the same in every scene"
            )
            call = None
            break
    return call


def is_random(checker: Checker, call: PassCall | None, option: str) -> bool:
    """Whether the value of an option differs between scenes."""
    value = call.option(option) if call is not None else None
    return value is not None and _differs(checker, value)


def _differs(checker: Checker, value: Value) -> bool:
    from ...ir import values as v

    match value:
        case v.Draw() | v.Measure():
            return True
        case v.Reference(name):
            return checker.definition(name).random
        case v.Operation(_, parts) | v.Items(parts):
            return any(_differs(checker, part) for part in parts)
        case v.Entries(entries):
            return any(_differs(checker, part) for _, part in entries)
        case v.PassCall():
            return any(_differs(checker, part) for _, part in value.options)
    return False


def only_one(checker: Checker, word: str, found: list[Placed]) -> Placed | None:
    """The statement that may be there once; each further one is reported."""
    for extra in found[1:]:
        labels = [Label(found[0].statement.span, "the first one")]
        span = extra.statement.span
        keyword = span.source.span(span.start, span.start + len(word))
        checker.report(Code.DUPLICATE_STATEMENT, keyword, labels=labels, word=word)
    return found[0] if found else None
