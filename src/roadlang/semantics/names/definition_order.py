"""Which names an expression mentions, and an order in which definitions can be looked at."""

from __future__ import annotations

from collections.abc import Iterator

from ...syntax.tree import nodes as ast
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
    stack: list[ast.Expression] = [expression]
    while stack:
        node = stack.pop()
        if isinstance(node, ast.Name):
            yield node.text
        else:
            stack.extend(reversed(_parts(node)))


def _parts(node: ast.Expression) -> tuple[ast.Expression, ...]:
    match node:
        case ast.Member():
            return (node.of,)
        case ast.Call():
            return tuple(argument.value for argument in node.arguments)
        case ast.Negate() | ast.Not() | ast.Temporal():
            return (node.operand,)
        case ast.Group():
            return (node.inner,)
        case ast.Arithmetic() | ast.Binding():
            return (node.left, node.right)
        case ast.Draw():
            return (node.low, node.high)
        case ast.Comparison() | ast.Logic():
            return node.operands
        case ast.Point() | ast.ListValue():
            return node.items
        case ast.MapValue():
            return tuple(entry.value for entry in node.entries)
    return ()
