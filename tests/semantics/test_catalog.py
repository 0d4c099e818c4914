"""Every page of the catalog that shows a scene file tells the truth about it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from roadlang.diagnostics import codes, page
from roadlang.plugins.discovery import load_registry
from roadlang.semantics import check_text

_BLOCK = re.compile(r"```roadlang (wrong|right)\n(.*?)```", re.DOTALL)
_OURS = re.compile(r"RL(1|2|35|45)")


def _examples() -> list[tuple[str, str, str]]:
    found = []
    for code in codes():
        if _OURS.match(code):
            found += [(code, kind, text) for kind, text in _BLOCK.findall(page(code).body)]
    return found


@pytest.mark.parametrize(("code", "kind", "text"), _examples())
def test_example_of_a_page(code: str, kind: str, text: str, tmp_path: Path) -> None:
    _, found = check_text(text, tmp_path / "scene.rl", {}, load_registry())
    reported = [diagnostic.code for diagnostic in found]
    if kind == "wrong":
        assert reported == [code], [diagnostic.message for diagnostic in found]
    else:
        assert not any(diagnostic.is_error for diagnostic in found), reported
        assert code not in reported


def test_every_page_shows_something() -> None:
    for code in codes():
        if _OURS.match(code):
            assert "```" in page(code).body, code
