"""No control character of a source, a name or a plugin ever reaches a terminal."""

from __future__ import annotations

import re
import sys
import unicodedata
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.cli.main import run
from roadlang.diagnostics import Diagnostic, Label, Source
from roadlang.diagnostics.printable import columns, printable
from roadlang.diagnostics.render import render, render_json

NASTY = [
    "\x1b]0;title\x07",
    "\x1b[2J\x1b[H",
    "\x9b31m",
    "\x08\x08\x08",
    "\x00",
    "\x7f",
    "a\rb",
    "\u202edrawkcab\u202c",
    "\u2066isolate\u2069",
    "zero\u200bwidth",
    "\u2028line\u2029paragraph",
    "\ufeffmark",
    "\udc80surrogate",
    "\U000e0041tag",
]
COLOR = re.compile(r"\x1b\[[0-9;]*m")


def unsafe(text: str) -> set[str]:
    """The characters of a text that a terminal must not get."""
    return {
        char
        for char in text
        if char != "\n" and unicodedata.category(char) in ("Cc", "Cf", "Cs", "Zl", "Zp")
    }


@pytest.mark.parametrize("text", NASTY)
def test_unsafe_characters_are_shown_as_their_code_points(text: str) -> None:
    assert unsafe(printable(text)) == set()
    assert f"U+{ord(next(iter(sorted(unsafe(text))))):04X}" in printable(text)


def test_ordinary_text_of_any_script_stays_as_it_is() -> None:
    for text in ("road", "straße", "道路 дорога", "e\u0301", "🚗"):
        assert printable(text) == text


@given(st.text(max_size=30))
def test_printable_text_has_no_unsafe_character(text: str) -> None:
    assert unsafe(printable(text)) == set()


@pytest.mark.parametrize("text", NASTY)
@pytest.mark.parametrize("color", [False, True])
def test_a_rendered_diagnostic_is_safe_wherever_the_text_comes_from(text: str, color: bool) -> None:
    source = Source(f"{text}.rl", f"road {text} here {text}")
    start = source.text.index("here")
    span = source.span(start, start + 4)
    found = Diagnostic(
        "RL001", "error", text, span, (text, f"a\n{text}"), (Label(source.span(0, 4), text),)
    )
    assert unsafe(COLOR.sub("", render(found, color=color))) == set()
    assert unsafe(render(Diagnostic("RL001", "error", text, path=text))) == set()
    assert unsafe(render_json([found])) == set()


@pytest.mark.parametrize("text", [text for text in NASTY if "\n" not in text])
def test_the_underline_stays_below_its_place(text: Any) -> None:
    source = Source("x.rl", f"{text} here")
    start = source.text.index("here")
    lines = render(Diagnostic("RL001", "error", "", source.span(start, start + 4))).splitlines()
    assert lines[-1].index("^^^^") == lines[-2].index("here")


def test_the_underline_stays_below_its_place_behind_wide_and_combining_characters() -> None:
    source = Source("x.rl", "道路 e\u0301 here")
    start = source.text.index("here")
    *_, line, underline = render(
        Diagnostic("RL001", "error", "", source.span(start, start + 4))
    ).splitlines()
    assert columns(line.partition("here")[0]) == len(underline.partition("^")[0])


PLUGIN = '''
from dataclasses import dataclass
from typing import ClassVar
from roadlang.api import Perturber, hookimpl

@dataclass(frozen=True)
class Evil(Perturber):
    """Clear \\x1b[2J the screen \\u202e."""

    name: ClassVar[str] = "evil"

    def displacement(self, road, random):
        raise ValueError("\\x1b]0;title\\x07")

@hookimpl
def roadlang_kinds():
    return [Evil]
'''
ROAD = "road main { draw with waypoints { points: [(0m, 0m), (90m, 20m)] }, width: 7m }\n"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Any]:
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(str(tmp_path))
    (tmp_path / "roadlang_evil.py").write_text(PLUGIN)
    info = tmp_path / "evil-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: evil\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text("[roadlang]\nevil = roadlang_evil\n")
    yield tmp_path
    sys.modules.pop("roadlang_evil", None)


@pytest.mark.parametrize(
    ("scene", "command"),
    [
        (ROAD + "rod x # \x1b]0;title\x07 \u202e", "check scene.rl"),
        (ROAD + "rod x # \x1b]0;title\x07 \u202e", "check --json scene.rl"),
        ('image p from "\x1b[2Jno.png" { scale: 1m/px }', "check scene.rl"),
        ('include "\x9b31m.rl"', "check scene.rl"),
        ('scenario s "a \x9b31m \u202e title"\n' + ROAD, "check --scenario scene.rl"),
        ('scenario s "a \x9b31m \u202e title"\n' + ROAD, "compile --json scene.rl"),
        (ROAD + "road bent from main { perturb with evil }", "compile scene.rl"),
        ("", "plugins"),
        ("", "plugins show evil"),
        ("", "plugins show \x1b[2J"),
        ("", "check \x1b[2J.rl"),
        ("", "check --\x1b[2J"),
        ("", "\x1b[2J"),
        ("", "explain \x1b[2J"),
        ("", "compile scene.rl --set \x1b[2J"),
        ("", "monitor \x1b]0;x\x07 drive.csv"),
        ("", "extract \x1b[2J.png"),
        ("", "init \x1b[2J/a\x00b.rl"),
    ],
)
@pytest.mark.parametrize("color", ["never", "always"])
def test_no_command_prints_control_characters(
    folder: Any, capsys: pytest.CaptureFixture[str], scene: str, command: str, color: str
) -> None:
    (folder / "scene.rl").write_text(scene, encoding="utf-8")
    run(["--color", color, *command.split(" ")])
    printed = capsys.readouterr()
    shown = COLOR.sub("", printed.out + printed.err)
    assert shown
    assert unsafe(shown) == set()


@pytest.mark.parametrize(
    ("char", "width"),
    [("a", 1), ("\u00e4", 1), ("\u0301", 0), ("\u20dd", 0), ("\u9053", 2), ("\uff21", 2)],
)
def test_how_many_columns_a_character_takes(char: str, width: int) -> None:
    """A letter, a combining accent, an enclosing circle, a wide character, a full-width letter."""
    assert columns(char) == width
