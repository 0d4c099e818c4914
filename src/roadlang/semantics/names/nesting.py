"""Limits how deep values are nested once the names in them are written out."""

from __future__ import annotations

from ...diagnostics import Code, diagnose
from ...syntax.tree import nodes as ast
from ...syntax.tree.walk import walk
from .definition_order import definition_of, definition_order
from .program import Program

MOST_LEVELS = 200
"""Later passes go through values by recursion, several frames a level, within Python's limit."""

_FOLDED = (
    ast.NumberLiteral,
    ast.Name,
    ast.NegateExpression,
    ast.ArithmeticExpression,
    ast.GroupExpression,
)
"""What is computed when it is checked, if it names nothing else: it is not nested afterwards."""


def report_nesting(program: Program) -> None:
    """RL024 for the first of each chain of names that is too deep; uses of it are left alone."""
    levels: dict[str, int] = {}
    constants: set[str] = set()
    for name in definition_order(program, "param", "let", "require", "expect"):
        nodes = list(walk(definition_of(program, name)))
        named = {node.text for node, _ in nodes if isinstance(node, ast.Name)}
        if named <= constants and all(isinstance(node, _FOLDED) for node, _ in nodes):
            constants.add(name)
            continue
        levels[name] = max(
            depth + (levels.get(node.text, 0) if isinstance(node, ast.Name) else 0)
            for node, depth in nodes
        )
        deepest = max((levels.get(other, 0) for other in named), default=0)
        if levels[name] > MOST_LEVELS >= deepest:
            span = program.declarations[name].name.span
            help_ = f"written out it has {levels[name]} levels; at most {MOST_LEVELS} are allowed"
            program.diagnostics.append(diagnose(Code.NESTING_TOO_DEEP, span, help=help_))
            program.spoiled.add(name)
