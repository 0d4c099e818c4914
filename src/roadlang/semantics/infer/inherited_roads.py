"""The road of an agent or object: its own, or that of the one that its position names."""

from __future__ import annotations

from ...syntax.tree import nodes as ast
from ..checker import Checker
from .calls import dotted
from .group_copies import group_of


def road_of(checker: Checker, statement: ast.Actor) -> ast.Expression | None:
    """What stands behind `on`; of `at ahead_of(ego, 20m)` without it, what stands there for `ego`.
    None of what is on no road."""
    seen: set[str] = set()
    found: ast.Actor | None = statement
    while found is not None and found.on is None and found.name.text not in seen:
        seen.add(found.name.text)
        found = named_in_position(checker, found)
    return None if found is None else found.on


def goes_in_circles(checker: Checker, statement: ast.Actor) -> bool:
    """Whether the places of agents and objects depend on each other in a circle, which is reported
    as a circular definition."""
    seen: set[str] = set()
    found: ast.Actor | None = statement
    while found is not None and found.name.text not in seen:
        seen.add(found.name.text)
        found = named_in_position(checker, found)
    return found is not None


def named_in_position(checker: Checker, statement: ast.Actor) -> ast.Actor | None:
    """The agent or object that a position is by (`ahead_of(ego, 20m)`), None of other positions."""
    call = statement.at
    if not isinstance(call, ast.CallExpression):
        return None
    function = call.function
    name = function.word if isinstance(function, ast.Name) else dotted(function)
    if name is None or not checker.registry.has("position", name):
        return None
    for argument in call.arguments:
        named = group_of(argument.value)
        if isinstance(named, ast.Name):
            declared = checker.program.declarations.get(named.text)
            if declared is not None and isinstance(declared.statement, ast.Actor):
                return declared.statement
    return None
