"""Follows the examples on a page of the catalog, in a folder with the files of `examples/` where
the page names one of them.

What a fenced block is follows from the words after its language, in the order of the page:

- `roadlang wrong`, `roadlang right`: a scene file. It is checked, and compiled if its check does
  not report the page's code. `wrong` gives this code once and no other error, `right` no error.
- `console wrong`, `console right`: each line that starts with `$ ` runs; `$ roadlang` runs in this
  process. The other lines are the start of lines that the commands print.
- `python wrong`, `python right`: each line that starts with `>>> ` is evaluated.
- `LANGUAGE NAME.EXTENSION`, `sh NAME`, `base64 NAME`: a file of that name. `roadlang_NAME.py` is
  installed as the plugin NAME; `ini entry_points.txt` adds entry points to it.
"""

from __future__ import annotations

import base64
import contextlib
import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from roadlang.cli.main import run
from roadlang.diagnostics import DiagnosticError, page
from roadlang.diagnostics.render import render_all
from roadlang.plugins.discovery import load_registry
from roadlang.semantics import check_text

EXAMPLES = Path(__file__).parents[2] / "examples"
MODES = ("wrong", "right")


@dataclass(frozen=True)
class Block:
    """A fenced block: its language, `wrong`, `right` or a file name (or ""), and its text."""

    language: str
    word: str
    text: str

    @property
    def is_file(self) -> bool:
        return bool(self.word) and self.word not in MODES


def blocks(code: str) -> list[Block]:
    found = re.findall(r"^```(\w+) ?([^\n]*)\n(.*?)^```$", page(code).body, re.M | re.S)
    return [Block(*parts) for parts in found]


def has_wrong_example(code: str) -> bool:
    return any(block.word == "wrong" for block in blocks(code))


class Follower:
    """Does what a page shows, and holds what was printed."""

    def __init__(self, code: str, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
        self._folder = folder
        self._capsys = capsys
        if any(path.name in page(code).body for path in EXAMPLES.iterdir()):
            for path in EXAMPLES.iterdir():
                if path.is_file():
                    shutil.copy(path, folder)

    def save(self, block: Block) -> None:
        path = self._folder / block.word
        if block.language == "base64":
            path.write_bytes(base64.b64decode(block.text))
        elif block.word == "entry_points.txt":
            for info in self._folder.glob("*.dist-info"):
                (info / block.word).write_text(block.text)
        else:
            path.write_text(block.text, encoding="utf-8")
        if block.language == "sh":
            path.chmod(0o755)
        plugin = re.fullmatch(r"roadlang_(\w+)\.py", block.word)
        if plugin:
            self._install(plugin[1])

    def output(self, block: Block, code: str) -> str:
        """What following an example prints, diagnostics included."""
        if block.language == "roadlang":
            return self._scene(block.text, code)
        if block.language == "python":
            return self._evaluated(block.text)
        assert block.language == "console", block
        return self._commands(block.text)

    def _scene(self, text: str, code: str) -> str:
        (self._folder / "scene.rl").write_text(text, encoding="utf-8")
        _, found = check_text(text, self._folder / "scene.rl", {}, load_registry())
        if any(diagnostic.is_error or diagnostic.code == code for diagnostic in found):
            return render_all(found)
        return render_all(found) + "\n" + self._roadlang("compile scene.rl -o out")

    def _evaluated(self, text: str) -> str:
        import roadlang.stl

        for line in text.splitlines():
            if line.startswith(">>> "):
                try:
                    eval(line[4:], {"roadlang": roadlang})  # noqa: S307 - our own pages
                except DiagnosticError as error:
                    return render_all(error.diagnostics)
        return ""

    def _commands(self, text: str) -> str:
        printed = ""
        for line in text.splitlines():
            if line.startswith("$ "):
                command = re.search(r"\broadlang (.*)", line)
                prefix = line[2 : command.start()] if command else ""
                if command and re.fullmatch(r"(\w+=\S* )*", prefix):
                    printed += self._roadlang(command[1], prefix)
                else:
                    printed += self._shell(line[2:])
        return printed

    def _roadlang(self, arguments: str, environment: str = "") -> str:
        with pytest.MonkeyPatch.context() as patch:
            for setting in environment.split():
                patch.setenv(*setting.split("=", 1))
            run(shlex.split(arguments))
        printed = self._capsys.readouterr()
        return printed.out + printed.err

    def _shell(self, command: str) -> str:
        path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
        done = subprocess.run(
            ["bash", "-c", command],
            env={**os.environ, "PATH": path},
            capture_output=True,
            text=True,
        )
        return done.stdout + done.stderr

    def _install(self, name: str) -> None:
        info = self._folder / f"{name}_plugin-1.2.dist-info"
        info.mkdir(exist_ok=True)
        (info / "METADATA").write_text(
            f"Metadata-Version: 2.1\nName: {name}-plugin\nVersion: 1.2\n"
        )
        (info / "entry_points.txt").write_text(f"[roadlang]\n{name} = roadlang_{name}\n")
        sys.modules.pop(f"roadlang_{name}", None)


@contextlib.contextmanager
def plugins_forgotten() -> Iterator[None]:
    """Leave no plugin imported that a page has installed."""
    before = set(sys.modules)
    try:
        yield
    finally:
        for name in set(sys.modules) - before:
            if re.match(r"roadlang_(?!standard|godot)", name):
                del sys.modules[name]


def reported(printed: str, severity: str = "") -> list[str]:
    """The codes of the diagnostics in a text."""
    found = re.findall(r"^(\w+)\[(RL\d+)\]", printed, re.MULTILINE)
    return [code for word, code in found if not severity or word == severity]


def expected_lines(block: Block) -> list[str]:
    """The lines of an example that its commands are to print."""
    if block.language == "roadlang":
        return []
    return [
        line for line in block.text.splitlines() if line and not line.startswith(("$ ", ">>> "))
    ]
