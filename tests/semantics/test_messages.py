"""What the checker says, word for word: a reader should know what is wrong and what to do.

Each part of `messages.txt` is some source (`>`), the statements that stand before it (`beside:`),
and the errors: line and column, code, message; then help, fixes and labels at other places.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from roadlang.plugins.discovery import load_registry
from roadlang.plugins.registry import Registry
from roadlang.semantics import check_text

BESIDE = {
    "road": "road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }\n",
    "car": "agent ego is car on main at 5m { drive with pure_pursuit { speed: 5m/s } }\n",
    "expect": "expect e: always (ego.speed < 9m/s)\n",
}
PARTS = (Path(__file__).parent / "messages.txt").read_text(encoding="utf-8").split("\n\n")


@cache
def registry() -> Registry:
    return load_registry()


def messages(before: str, text: str, folder: Path) -> list[str]:
    _, found = check_text(f"{before}{text}\n", folder / "scene.rl", {}, registry())
    said = []
    for error in found:
        assert error.span is not None
        line = error.span.line - before.count("\n")
        said.append(f"{line}:{error.span.column} {error.code} {error.message}")
        said += [f"  help: {help}" for help in error.help]
        said += [f"  fix: {fix.replacement}" for fix in error.fixes]
        said += [f"  there: {label.text}" for label in error.labels]
    return said


@pytest.mark.parametrize("part", PARTS, ids=lambda part: part.partition("\n")[0][2:])
def test_a_message_says_what_is_wrong_and_what_to_do(part: str, tmp_path: Path) -> None:
    lines = part.rstrip("\n").split("\n")
    text = "\n".join(line[2:] for line in lines if line.startswith("> "))
    (beside,) = [line.split()[1:] for line in lines if line.startswith("beside: ")] or [[]]
    said = [line for line in lines if not line.startswith(("> ", "beside: "))]
    assert messages("".join(BESIDE[name] for name in beside), text, tmp_path) == said
