"""What belongs to a run and not to a scene: sampling, simulation, falsification, outputs."""

from __future__ import annotations

from collections.abc import Sequence

from ...diagnostics import Code, Span
from ...ir.values import PassCall
from ...plugins.options import OptionSchema
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..infer.blocks import lower_call
from ..infer.kinds import display_name, find_default, find_kind
from ..infer.statement_spec import StatementSpec
from ..names.program import PlacedStatement
from .randomness import is_random


def lower_run_step(
    checker: Checker, spec: StatementSpec, placed: PlacedStatement
) -> PassCall | None:
    """`sample`, `simulate`, `falsify`."""
    statement = placed.statement
    assert isinstance(statement, ast.RunStep)
    word = statement.word
    keyword = statement.span.source.span(statement.span.start, statement.span.start + len(word))
    name = statement.kind.text if statement.kind else spec.default_kind
    span = statement.kind.span if statement.kind else keyword
    return _run_call(checker, word, name, span, statement, word, spec.schema)


def lower_emit(checker: Checker, spec: StatementSpec, placed: PlacedStatement) -> PassCall | None:
    """An `emit` statement as a call of its kind; None where it has errors."""
    statement = placed.statement
    assert isinstance(statement, ast.Emit)
    kind = statement.kind
    place = f"emit {placed.number}"
    return _run_call(checker, spec.word, kind.text, kind.span, statement, place, spec.schema)


def _run_call(
    checker: Checker,
    verb: str,
    name: str,
    span: Span,
    statement: ast.RunStep | ast.Emit,
    place: str,
    common: Sequence[OptionSchema],
) -> PassCall | None:
    """A call whose options belong to the run: they cannot differ between scenes. The default of
    the verb where `name` is empty."""
    found = find_kind(checker, verb, name, span) if name else find_default(checker, verb, span)
    if found is None:
        return None
    context = Context(user=place, place=place)
    owner = f"`{display_name(verb, name or found.entry.name)}`"
    block = statement.block
    call = lower_call(checker, found, block, common, context, owner, span, statement.span)
    for option in block.options if call is not None and block is not None else ():
        value = call.option(option.key.text) if call is not None else None
        if value is not None and is_random(checker, value):
            what = f"`{option.key.text}`"
            checker.report(
                Code.MUST_NOT_BE_RANDOM,
                option.value.span,
                what=what,
                expected="the same in every scene",
            )
            call = None
            break
    return call
