"""Which names a declaration mentions, and an order in which declarations can be looked at."""

from __future__ import annotations

from collections.abc import Iterator

from ...syntax.tree import nodes as ast
from ...syntax.tree.walk import walk
from .program import Program


def definition_order(program: Program, *roles: str) -> list[str]:
    """The names declared by these words, those that others mention first, cycles apart.

    Definitions are found by recursion; in this order a long chain of them is no deep one.
    """
    names = [found.name.text for found in program.in_role(*roles)]
    waiting = set(names)
    order: list[str] = []
    for start in names:
        if start not in waiting:
            continue
        waiting.discard(start)
        stack = [(start, names_in(definition_of(program, start)))]
        while stack:
            name, rest = stack[-1]
            for other in rest:
                if other in waiting:
                    waiting.discard(other)
                    stack.append((other, names_in(definition_of(program, other))))
                    break
            else:
                stack.pop()
                order.append(name)
    return order


def definition_of(program: Program, name: str) -> ast.SyntaxNode:
    """What a name is declared as: a value, here or from outside, or a whole statement."""
    setting = program.settings.get(name)
    if setting is not None:
        return setting.value
    statement = program.declarations[name].statement
    return statement.value if isinstance(statement, ast.Param | ast.Let) else statement


def names_in(node: ast.SyntaxNode) -> Iterator[str]:
    """The names that a part of the tree mentions, left to right."""
    return (part.text for part, _ in walk(node) if isinstance(part, ast.Name))
