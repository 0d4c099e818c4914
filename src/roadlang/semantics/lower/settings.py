"""Statements that are nothing but options: `world`."""

from __future__ import annotations

from ...diagnostics import Code
from ...ir.values import Options
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..infer.blocks import lower_options, lower_passes
from ..infer.statement_spec import StatementSpec
from ..names.program import PlacedStatement
from .randomness import is_random


def lower_settings(checker: Checker, spec: StatementSpec, placed: PlacedStatement) -> Options:
    """The options as values."""
    block: ast.Block | None = getattr(placed.statement, "block", None)
    context = Context(user=spec.word, place=spec.word)
    span = placed.statement.span
    bound = lower_options(checker, spec, block, context, span)
    lower_passes(checker, spec, block, context)
    traffic = bound.stated.get("traffic")
    if traffic is not None and traffic.value is not None and is_random(checker, traffic.value):
        expected = "the same in every scene: all lanes and junctions depend on it"
        checker.report(Code.MUST_NOT_BE_RANDOM, traffic.span, what="`traffic`", expected=expected)
    return bound.values
