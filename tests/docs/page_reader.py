"""Follows a page of the documentation to the letter.

How a code block is meant follows from the words behind its language:

- `roadlang NAME.rl`: a scene file, saved as NAME.rl; it checks without an error.
- `roadlang wrong CODE`: a scene file that gives exactly this error.
- `roadlang fragment`: statements that parse.
- `python NAME.py`, `toml NAME.toml`, `yaml NAME.yaml`, `xml NAME.osm`: a file of that name.
- `python` alone: a program that runs.
  `python continued`: its next lines.
- `console`: the lines that begin `$ roadlang` or `$ pip install ./` run, and succeed.
  `console godot`: the same, left out where there is no Godot engine.
- A picture with a title, `![...](images/NAME "FILE")`, is a copy of the FILE that the commands of
  the page write.
"""

from __future__ import annotations

import contextlib
import io
import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import pytest

from roadlang.cli.main import run
from roadlang_godot.engines.engine import find
from roadlang_godot.faults import EngineError
from tests.docs.python_session import PythonSession

ROOT = Path(__file__).parents[2]


@dataclass(frozen=True)
class Block:
    """A fenced code block and the line it begins on."""

    language: str
    words: tuple[str, ...]
    text: str
    line: int


def blocks(page: Path) -> Iterator[Block]:
    text = page.read_text(encoding="utf-8")
    for match in re.finditer(r"^```(\w+)([^\n]*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        line = text.count("\n", 0, match.start()) + 1
        yield Block(match[1], tuple(match[2].split()), match[3], line)


class Reader:
    """Someone who follows a page to the letter, in a folder with the pictures of the examples."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.site = folder / ".site"
        self.left_out = False
        self.has_code = False
        self.program: PythonSession | None = None
        for path in (ROOT / "examples").iterdir():
            if path.is_file():
                shutil.copy(path, folder)
        shutil.copytree(ROOT / "examples", folder / "examples")
        shutil.copytree(ROOT / "plugins" / "roadlang-chicane", folder / "plugins/roadlang-chicane")

    @property
    def environment(self) -> dict[str, str]:
        bin_folder = str(Path(sys.executable).parent)
        return {
            **os.environ,
            "PYTHONPATH": str(self.site),
            "PATH": f"{bin_folder}{os.pathsep}{os.environ['PATH']}",
        }

    def run(self, *command: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            command, cwd=self.folder, env=self.environment, capture_output=True, text=True
        )

    def runs(self, piece: str, *, continued: bool) -> None:
        """A program succeeds, or what continues one."""
        if not continued or self.program is None:
            self.end_program()
            self.program = PythonSession(self.folder, self.environment)
        assert not (fault := self.program.run(piece)), fault

    def end_program(self) -> None:
        if self.program is not None:
            self.program.close()
        self.program = None

    @cached_property
    def has_godot(self) -> bool:
        """Whether an engine is there. Where it is required, it is taken to be."""
        if os.environ.get("ROADLANG_REQUIRE_GODOT") == "1":
            return True
        try:
            find()
        except EngineError:
            return False
        return True

    def follow(self, block: Block) -> None:
        if block.language == "python" and block.words in ((), ("continued",)):
            self.runs(block.text, continued=bool(block.words))
        elif block.language in ("python", "toml", "yaml", "xml") and block.words:
            path = self.folder / block.words[0]
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(block.text, encoding="utf-8")
            self.has_code |= block.language in ("python", "toml")
        elif block.language == "roadlang":
            self.check(block)
        elif block.language == "console":
            if "godot" in block.words and not self.has_godot:
                self.left_out = True
                return
            for line in block.text.splitlines():
                self.console(line, apart="godot" in block.words)

    def check(self, block: Block) -> None:
        mode = block.words[0] if block.words else "scene.rl"
        if mode == "fragment":
            from roadlang.diagnostics import Source
            from roadlang.syntax import parse

            _, found = parse(Source(f"line {block.line}", block.text))
            assert not [d for d in found if d.is_error], found
            return
        name = "wrong.rl" if mode == "wrong" else mode
        (self.folder / name).write_text(block.text, encoding="utf-8")
        if mode == "wrong":
            done = self.roadlang("check", name)
            assert re.findall(r"error\[(RL\d+)\]", done.stderr) == [block.words[1]], done.stderr
        else:
            done = self.roadlang("check", name)
            assert done.returncode == 0, f"check {name}\n{done.stdout}{done.stderr}"

    def console(self, line: str, *, apart: bool) -> None:
        words = shlex.split(line.removeprefix("$ "), comments=True)
        if line.startswith("$ roadlang"):
            done = self.roadlang(*words[1:], apart=apart)
            # A search that finds failures ends with 4: that is its success.
            good = (0, 4 if words[1] == "falsify" else 0)
            assert done.returncode in good, f"{line}\n{done.stdout}{done.stderr}"
        elif line.startswith("$ pip install ./"):
            options = ("--no-deps", "--no-build-isolation", "--quiet", "--target", str(self.site))
            self.has_code = True
            self.succeeds(sys.executable, "-m", "pip", "install", *options, *words[2:])

    def succeeds(self, *command: str) -> None:
        done = self.run(*command)
        assert done.returncode == 0, f"{shlex.join(command)}\n{done.stdout}{done.stderr}"

    def roadlang(self, *words: str, apart: bool = False) -> subprocess.CompletedProcess[str]:
        """A command, in this process unless `apart`, or the page has programs or plugins."""
        if apart or self.has_code:
            return self.run(sys.executable, "-m", "roadlang", *words)
        out, err = io.StringIO(), io.StringIO()
        with pytest.MonkeyPatch.context() as patch:
            patch.chdir(self.folder)
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
                code = run(words)
        return subprocess.CompletedProcess(words, code, out.getvalue(), err.getvalue())


def pictures(page: Path) -> Iterator[tuple[Path, str]]:
    """Pictures with a title: where the page has them, and the file that they are a copy of."""
    text = page.read_text(encoding="utf-8")
    for target, title in re.findall(r"!\[[^\]]*\]\((\S+) \"([^\"]+)\"\)", text):
        yield page.parent / target, title


def follow(page: Path, folder: Path) -> Reader:
    """Follow a page in `folder`. Raises `AssertionError` where the page does not tell the truth."""
    reader = Reader(folder)
    for block in blocks(page):
        try:
            reader.follow(block)
        except AssertionError as error:
            raise AssertionError(f"{page.name}, line {block.line}: {error}") from None
    reader.end_program()
    return reader
