"""Names of files that are included `as` a name: `left.main` is `main` of the file `left`."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, fields, replace
from typing import Any, TypeVar

from ...diagnostics import Span
from ...syntax.tree import nodes as ast

Node = TypeVar("Node", bound=ast.SyntaxNode)


@dataclass
class Namespace:
    """What the statements of a file, and of those that it includes without a name, declare.

    `prefix` stands before these names in the program: `left.`, or nothing for the main file.
    `aliases` are the names of included files, with their namespaces.
    """

    prefix: str = ""
    declared: set[str] = field(default_factory=set)
    aliases: dict[str, Namespace] = field(default_factory=dict)
    spans: dict[str, Span] = field(default_factory=dict)
    """where each alias is written"""


Unknown = Callable[[ast.Member, Namespace, str], None]
"""Called with a member that an included file does not declare, that file's names and its alias."""


def resolved(statement: Node, space: Namespace, unknown: Unknown) -> Node:
    """A statement with every name of its namespace, and of the files that it names, in full."""
    if not space.prefix and not space.aliases:
        return statement
    renamed: Node = _rewritten(statement, space, unknown)
    name = getattr(renamed, "name", None)
    if isinstance(name, ast.Word) and isinstance(renamed, ast.Statement):
        renamed = replace(renamed, name=replace(name, text=space.prefix + name.text))  # type: ignore[call-arg]
    return renamed


def _rewritten(node: Any, space: Namespace, unknown: Unknown) -> Any:
    if isinstance(node, ast.Name):
        if not space.prefix or node.text not in space.declared:
            return node
        return replace(node, text=space.prefix + node.text, short=node.text)
    if isinstance(node, ast.Member):
        return _member(node, space, unknown)
    if isinstance(node, tuple):
        return tuple(_rewritten(item, space, unknown) for item in node)
    if not isinstance(node, ast.SyntaxNode) or isinstance(node, ast.Word | ast.KindName):
        return node
    changes = {
        name: after
        for name, before in _fields(node)
        if (after := _rewritten(before, space, unknown)) is not before
    }
    return replace(node, **changes) if changes else node


def _fields(node: ast.SyntaxNode) -> Iterable[tuple[str, Any]]:
    return ((item.name, getattr(node, item.name)) for item in fields(node) if item.name != "span")


def _member(member: ast.Member, space: Namespace, unknown: Unknown) -> ast.Expression:
    """`left.main` as the name that it is; `left.ego.speed` as the member of one."""
    inner, alias = _space_of(member.of, space)
    if inner is None:
        of = _rewritten(member.of, space, unknown)
        return member if of is member.of else replace(member, of=of)
    name = member.name.text
    if name not in inner.declared and name not in inner.aliases:
        unknown(member, inner, alias)
    return ast.Name(inner.prefix + name, span=member.span)


def _space_of(node: ast.Expression, space: Namespace) -> tuple[Namespace | None, str]:
    """The namespace that an expression names, with its alias."""
    if isinstance(node, ast.Name):
        return space.aliases.get(node.text), node.text
    if isinstance(node, ast.Member):
        outer, _ = _space_of(node.of, space)
        if outer is not None:
            return outer.aliases.get(node.name.text), node.name.text
    return None, ""
