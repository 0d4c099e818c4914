"""Which names an expression mentions, and an order in which definitions can be looked at."""

from __future__ import annotations

from collections.abc import Iterator

from ...syntax.tree import nodes as ast
from ...syntax.tree.walk import walk
from .program import Program, expression_of


def definition_order(program: Program) -> list[str]:
    """The `param`s and `let`s, those that others mention first, as far as there is such an order.

    Definitions are found by recursion; in this order a long chain of them is no deep one.
    """
    names = [found.name.text for found in program.in_role("param", "let")]
    waiting = set(names)
    order: list[str] = []
    for start in names:
        if start not in waiting:
            continue
        waiting.discard(start)
        stack = [(start, names_in(expression_of(program, start)))]
        while stack:
            name, rest = stack[-1]
            for other in rest:
                if other in waiting:
                    waiting.discard(other)
                    stack.append((other, names_in(expression_of(program, other))))
                    break
            else:
                stack.pop()
                order.append(name)
    return order


def names_in(expression: ast.Expression) -> Iterator[str]:
    """The names that an expression mentions, left to right."""
    return (node.text for node, _ in walk(expression) if isinstance(node, ast.Name))
