"""What stands in parentheses is at its place, with them."""

from __future__ import annotations

import pytest

from roadlang.diagnostics import Source
from roadlang.syntax import parse
from roadlang.syntax.tree import nodes as ast
from roadlang.syntax.tree.walk import walk


@pytest.mark.parametrize(
    ("text", "groups"),
    [
        ("let a = 2 * (b + 1m)\n", ["(b + 1m)"]),
        ("let a = ((b) + c)\n", ["((b) + c)", "(b)"]),
        ("require r: always ( x > 1m )\n", ["( x > 1m )"]),
    ],
)
def test_a_group_begins_and_ends_with_its_parentheses(text: str, groups: list[str]) -> None:
    tree, faults = parse(Source("group.rl", text))
    assert not faults
    found = [node for node, _ in walk(tree) if isinstance(node, ast.GroupExpression)]
    assert [node.span.text for node in found] == groups
