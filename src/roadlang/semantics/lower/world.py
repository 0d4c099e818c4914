"""The world: light, weather and grip."""

from __future__ import annotations

from ...ir.values import Value
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..infer.blocks import lower_options, refuse_passes
from ..infer.statements import STATEMENTS
from ..names.program import Placed


def lower_world(checker: Checker, placed: Placed) -> tuple[tuple[str, Value], ...]:
    """The options of the `world` statement as values."""
    statement = placed.statement
    assert isinstance(statement, ast.World)
    context = Context(user="world", place="world")
    schema = STATEMENTS["world"].schema
    bound = lower_options(checker, "world", statement.block, schema, context, statement.span)
    refuse_passes(checker, "world", statement.block.passes if statement.block else ())
    return bound.values
