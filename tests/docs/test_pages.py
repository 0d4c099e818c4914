"""The documentation does what it says: its files check, its commands run, its plugins install.

How a code block is meant follows from the words behind its language:

- `roadlang NAME.rl`: a scene file, saved as NAME.rl; it checks without an error.
- `roadlang wrong CODE`: a scene file that gives exactly this error.
- `roadlang fragment`: statements that parse.
- `python NAME.py`, `toml NAME.toml`: a file of that name. `python` alone: a program that runs.
- `console`: the lines that begin `$ roadlang` or `$ pip install ./` run, and succeed.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]
GENERATED = {"kinds.md", "statements.md", "errors.md", "api.md"}
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
WRITTEN = [page for page in PAGES if page.name not in GENERATED]


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
        for path in (ROOT / "examples").iterdir():
            if path.is_file():
                shutil.copy(path, folder)
        shutil.copytree(ROOT / "examples", folder / "examples")
        shutil.copytree(ROOT / "plugins" / "roadlang-chicane", folder / "plugins/roadlang-chicane")

    def run(self, *command: str) -> subprocess.CompletedProcess[str]:
        bin_folder = str(Path(sys.executable).parent)
        environment = {
            **os.environ,
            "PYTHONPATH": str(self.site),
            "PATH": f"{bin_folder}{os.pathsep}{os.environ['PATH']}",
        }
        return subprocess.run(
            command, cwd=self.folder, env=environment, capture_output=True, text=True
        )

    def follow(self, block: Block) -> None:
        if block.language in ("python", "toml") and block.words:
            path = self.folder / block.words[0]
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(block.text, encoding="utf-8")
        elif block.language == "python":
            self.succeeds(sys.executable, "-c", block.text)
        elif block.language == "roadlang":
            self.check(block)
        elif block.language == "console":
            for line in block.text.splitlines():
                self.console(line)

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
            done = self.run(sys.executable, "-m", "roadlang", "check", name)
            assert re.findall(r"error\[(RL\d+)\]", done.stderr) == [block.words[1]], done.stderr
        else:
            self.succeeds(sys.executable, "-m", "roadlang", "check", name)

    def console(self, line: str) -> None:
        words = shlex.split(line.removeprefix("$ "), comments=True)
        if line.startswith("$ roadlang"):
            self.succeeds(sys.executable, "-m", *words)
        elif line.startswith("$ pip install ./"):
            options = ("--no-deps", "--no-build-isolation", "--quiet", "--target", str(self.site))
            self.succeeds(sys.executable, "-m", "pip", "install", *options, *words[2:])

    def succeeds(self, *command: str) -> None:
        done = self.run(*command)
        assert done.returncode == 0, f"{shlex.join(command)}\n{done.stdout}{done.stderr}"


@pytest.mark.slow
@pytest.mark.parametrize("page", WRITTEN, ids=lambda page: page.name)
def test_a_reader_who_follows_the_page_succeeds(page: Any, tmp_path: Path) -> None:
    reader = Reader(tmp_path)
    for block in blocks(page):
        try:
            reader.follow(block)
        except AssertionError as error:
            raise AssertionError(f"{page.name}, line {block.line}: {error}") from None


def test_the_generated_pages_are_current() -> None:
    done = subprocess.run(
        [sys.executable, str(ROOT / "docs" / "generate.py"), "--check"],
        capture_output=True,
        text=True,
        env={**os.environ, "ROADLANG_NO_PLUGINS": ""},
    )
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_link_within_the_project_leads_somewhere(page: Any) -> None:
    text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        path = target.partition("#")[0]
        if path and not path.startswith(("http:", "https:")):
            assert (page.parent / path).exists(), f"{page.name} links to {target}"


def test_the_guide_shows_a_plugin_of_every_kind_that_strangers_write() -> None:
    guide = (ROOT / "docs" / "plugins.md").read_text(encoding="utf-8")
    for base in ("Extractor", "Perturber", "Signal", "Monitor", "Backend", "Controller"):
        assert re.search(rf"^class \w+\({base}\)", guide, re.MULTILINE), base


def test_the_guide_explains_the_chicane_plugin_as_it_is() -> None:
    guide = (ROOT / "docs" / "plugins.md").read_text(encoding="utf-8")
    folder = ROOT / "plugins" / "roadlang-chicane"
    for name in ("pyproject.toml", "roadlang_chicane.py"):
        for paragraph in (folder / name).read_text(encoding="utf-8").strip().split("\n\n"):
            assert paragraph.strip("\n") in guide, f"{name}: {paragraph}"


def test_the_command_reference_has_every_command_and_no_other() -> None:
    import click

    from roadlang.cli.commands import LazyGroup

    page = (ROOT / "docs" / "commands.md").read_text(encoding="utf-8")
    documented = re.findall(r"^\| `roadlang (\w+)", page, re.MULTILINE)
    commands = LazyGroup("roadlang").list_commands(click.Context(click.Command("roadlang")))
    assert sorted(documented) == sorted(commands)
