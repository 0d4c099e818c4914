"""What plugins import from the public API is there, also where only a type checker looks."""

from __future__ import annotations

import ast
from importlib import import_module
from pathlib import Path

PLUGINS = Path(__file__).parents[2] / "plugins"
PUBLIC = ("roadlang", "roadlang.api", "roadlang.commands", "roadlang.geometry", "roadlang.testing")


def test_names_that_plugins_import_exist() -> None:
    missing, seen = set(), set()
    for path in PLUGINS.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.module in PUBLIC:
                names = {(node.module, alias.name) for alias in node.names}
                seen |= names
                missing |= {f"{path.name}: {m}.{n}" for m, n in names - _there(names)}
    assert len(seen) > 200
    assert missing == set()


def _there(names: set[tuple[str, str]]) -> set[tuple[str, str]]:
    return {(module, name) for module, name in names if hasattr(import_module(module), name)}
