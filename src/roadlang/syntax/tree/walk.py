"""Goes through a tree without recursion: a tree may be deep, the Python stack may not."""

from __future__ import annotations

from collections.abc import Iterator

from . import nodes as ast


def children(node: ast.Node) -> tuple[ast.Node, ...]:
    """The expressions and blocks directly below a node, in order of place."""
    match node:
        case ast.Number() | ast.Name() | ast.String() | ast.Text() | ast.Boolean():
            return ()
        case ast.Arithmetic():
            return (node.left, node.right)
        case ast.Comparison() | ast.Logic():
            return node.operands
        case ast.Call():
            return (node.function, *(argument.value for argument in node.arguments))
        case ast.Group():
            return (node.inner,)
        case ast.Member():
            return (node.of,)
        case ast.Negate() | ast.Not():
            return (node.operand,)
        case ast.Draw() | ast.Interval():
            return (node.low, node.high)
        case ast.Temporal():
            return (*_present(node.interval), node.operand)
        case ast.Binding():
            return (node.left, *_present(node.interval), node.right)
        case ast.Point() | ast.ListValue() | ast.Block():
            return node.items
        case ast.MapValue():
            return node.entries
        case ast.Option() | ast.MapEntry() | ast.Param() | ast.Let():
            return (node.value,)
        case ast.Pass() | ast.Include() | ast.World() | ast.Plan() | ast.Emit():
            return _present(node.block)
        case ast.Geometry():
            return _present(node.source, node.block)
        case ast.Constraint():
            return _present(node.formula, node.block)
        case ast.Actor():
            return _present(node.kind, node.on, node.at, node.block)
    return ()


def _present(*nodes: ast.Node | None) -> tuple[ast.Node, ...]:
    return tuple(node for node in nodes if node is not None)


def walk(root: ast.Node) -> Iterator[tuple[ast.Node, int]]:
    """Every node of a tree with its depth, a node before what is below it."""
    stack = [(root, 1)]
    while stack:
        node, depth = stack.pop()
        yield node, depth
        stack.extend((child, depth + 1) for child in reversed(children(node)))
