"""Definitions come after those that they name, each once."""

from __future__ import annotations

from pathlib import Path

from roadlang.semantics.names.definition_order import definition_order
from roadlang.semantics.names.including import load


def test_each_definition_comes_once_after_what_it_names() -> None:
    text = "let a = b + c\nlet b = 2 * d\nparam c = b\nlet d = 1\nlet e = e + a\nparam f = 2\n"
    program = load(Path("scene.rl"), text, {})
    assert definition_order(program, "param", "let") == ["d", "b", "c", "a", "e", "f"]
    assert definition_order(program, "param") == ["c", "f"]
