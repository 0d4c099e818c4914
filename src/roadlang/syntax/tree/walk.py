"""Goes through a tree without recursion: a tree may be deep, the Python stack may not."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields
from functools import cache
from typing import Any

from . import nodes as ast


def children(node: ast.SyntaxNode) -> Iterator[ast.SyntaxNode]:
    """The expressions and blocks directly below a node, in order of place.

    Words and names of kinds are no children, and an argument stands for its value.
    """
    kind: Any = type(node)
    for name in _field_names(kind):
        value = getattr(node, name)
        for child in value if isinstance(value, tuple) else (value,):
            if isinstance(child, ast.Argument):
                yield child.value
            elif isinstance(child, ast.SyntaxNode) and not isinstance(
                child, ast.Word | ast.KindName
            ):
                yield child


@cache
def _field_names(node: Any) -> tuple[str, ...]:
    return tuple(field.name for field in fields(node) if not field.name.endswith("span"))


def walk(root: ast.SyntaxNode) -> Iterator[tuple[ast.SyntaxNode, int]]:
    """Every node of a tree with its depth, a node before what is below it."""
    stack = [(root, 1)]
    while stack:
        node, depth = stack.pop()
        yield node, depth
        stack.extend((child, depth + 1) for child in reversed(tuple(children(node))))
