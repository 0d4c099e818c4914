"""What is said of scene files with one mistake each, in lines."""

from __future__ import annotations

from collections.abc import Iterator

from roadlang.plugins.discovery import registry_of
from roadlang.semantics import check_text
from tests.golden.comparing import SCENES
from tests.golden.habit_views import edited
from tests.golden.language_views import said

_FOLDER = SCENES / "mistakes"
_BEFORE = """road main { draw with segments { pieces: [straight(80m), arc(60m, 40deg)] } lanes: 2 }
agent ego is car on main at 20m { drive with car_follow { speed: 9m/s } }
"""


_SET = (
    *({"width": "9m"}, {"width": " 9 s "}, {"widht": "  3m "}, {"main": "3m"}, {"ego": "3"}),
    *({"width": "3m +"}, {"width": ""}, {"width": "main"}, {"width": "1m..2m"}, {"width": '"a"'}),
    *({"width": "3"}, {"width": "(1m, 2m)"}, {"bend": "3m", "width": "3m)"}, {"width": "4m # c"}),
    *({"s.width": "3m"}, {"time": "3s"}, {"width": "widht"}, {"width": "-1m"}, {"width": "true"}),
)


def set_lines() -> Iterator[str]:
    """Values of params from outside."""
    text = (_FOLDER / "street.rl").read_text(encoding="utf-8") + _BEFORE
    for settings in _SET:
        yield f"--set {settings}"
        _, diagnostics = check_text(text, _FOLDER / "scene.rl", settings, registry_of({}))
        for found in diagnostics:
            yield "  " + said(found).replace(str(SCENES), "SCENES").replace("\n", " / ")


def edited_mistake_lines(edits: int) -> Iterator[str]:
    """Each part of `mistakes.txt` with `edits` changes of one token each."""
    registry = registry_of({})
    text = (_FOLDER / "mistakes.txt").read_text(encoding="utf-8")
    for part in text.strip().split("\n\n"):
        for changed in edited(part, edits):
            yield f"> {changed!r}"
            try:
                full = f"{_BEFORE}{changed}\n"
                _, diagnostics = check_text(full, _FOLDER / "scene.rl", {}, registry)
            except RecursionError:
                continue
            for found in diagnostics[:3]:
                yield "  " + said(found).replace(str(SCENES), "SCENES").replace("\n", " / ")


def mistake_lines() -> Iterator[str]:
    """Each part of `mistakes.txt`, and all errors and warnings of it."""
    registry = registry_of({})
    text = (_FOLDER / "mistakes.txt").read_text(encoding="utf-8")
    for part in text.strip().split("\n\n"):
        yield from (f"> {line}" for line in part.splitlines())
        _, diagnostics = check_text(f"{_BEFORE}{part}\n", _FOLDER / "scene.rl", {}, registry)
        for found in diagnostics:
            yield "  " + said(found).replace(str(SCENES), "SCENES").replace("\n", " / ")
