"""Refuses formulas that are too large before anything is inferred of them."""

from __future__ import annotations

from ...diagnostics import Code, diagnose
from ...syntax.tree import nodes as ast
from ...syntax.tree.walk import walk
from .definition_order import definition_of
from .program import Program

MOST_PARTS = 50_000
"""Parts of formulas, which are judged in a few seconds, and values that are used through names. A
`let` that uses another twice doubles it: sixteen of them in a row reach this."""


def drop_large_formulas(program: Program) -> None:
    """RL242 for each statement whose comparisons alone, written out, are more than `MOST_PARTS`.

    The statement is dropped: to infer what it holds takes many times as long as to read it.
    """
    for declaration in program.in_role("param", "let", "require", "expect"):
        name = declaration.name.text
        if _parts(definition_of(program, name)) > MOST_PARTS:
            span, most = declaration.name.span, f"{MOST_PARTS:,}"
            found = diagnose(Code.TOO_LARGE_WRITTEN_OUT, span, what=name, most=most)
            program.diagnostics.append(found)
            program.spoiled.add(name)
            del program.declarations[name]


def _parts(definition: ast.SyntaxNode) -> int:
    """At least how many parts the formulas of a definition have: three for each comparison."""
    comparisons = (
        node for node, _ in walk(definition) if isinstance(node, ast.ComparisonExpression)
    )
    return sum(3 * len(comparison.operators) for comparison in comparisons)
