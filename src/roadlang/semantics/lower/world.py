"""The world: light, weather and grip."""

from __future__ import annotations

from ...ir.values import Value
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..infer.blocks import lower_options, refuse_passes
from ..infer.statement_spec import StatementSpec
from ..names.program import PlacedStatement


def lower_world(
    checker: Checker, spec: StatementSpec, placed: PlacedStatement
) -> tuple[tuple[str, Value], ...]:
    """The options of the `world` statement as values."""
    statement = placed.statement
    assert isinstance(statement, ast.World)
    context = Context(user="world", place="world")
    bound = lower_options(checker, spec.word, statement.block, spec.schema, context, statement.span)
    refuse_passes(checker, "world", statement.block.passes if statement.block else ())
    return bound.values
