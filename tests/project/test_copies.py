"""One rule, one home: no function of the packages is written a second time."""

from __future__ import annotations

import ast
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).parents[2]
SHORTEST = 110
"""Characters of a body, without its docstring: shorter ones are alike by chance."""
ALLOWED = {
    "__getattr__",  # of packages that import their names when these are asked for
    "bend",  # a closure over the tape of each kind of step
}


def test_no_function_stands_twice() -> None:
    places: dict[str, list[str]] = defaultdict(list)
    for folder in ("src/roadlang", "plugins"):
        for path in sorted((ROOT / folder).rglob("*.py")):
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if isinstance(node, ast.FunctionDef) and node.name not in ALLOWED:
                    body = "\n".join(map(ast.unparse, node.body[_is_documented(node) :]))
                    if len(body) >= SHORTEST:
                        name = f"{path.relative_to(ROOT)}:{node.lineno} {node.name}"
                        places[body].append(name)
    copies = [names for names in places.values() if len(names) > 1]
    assert not copies, copies


def _is_documented(node: ast.FunctionDef) -> bool:
    return ast.get_docstring(node) is not None
