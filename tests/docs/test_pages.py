"""The documentation does what it says: its files check, its commands run, its plugins install.

`page_reader.py` says what is made of a page.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from roadlang import api
from tests.docs.page_reader import follow, pictures

ROOT = Path(__file__).parents[2]
GENERATED = {"kinds.md", "statements.md", "errors.md", "api.md"}
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
CHICANE = ROOT / "plugins" / "roadlang-chicane" / "README.md"
WRITTEN = [*(page for page in PAGES if page.name not in GENERATED), CHICANE]
LINKING = [*PAGES, CHICANE, ROOT / "CHANGELOG.md", ROOT / "CONTRIBUTING.md"]


@pytest.mark.slow
@pytest.mark.parametrize("page", WRITTEN, ids=lambda page: page.name)
def test_a_reader_who_follows_the_page_succeeds(page: Path, tmp_path: Path) -> None:
    reader = follow(page, tmp_path)
    for picture, source in pictures(page):
        assert reader.left_out or (tmp_path / source).exists(), f"{picture.name} is no {source}"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_pictures_are_small(page: Path) -> None:
    for picture, _ in pictures(page):
        assert picture.stat().st_size <= 150_000, picture.name


def test_the_generated_pages_are_current() -> None:
    done = subprocess.run(
        [sys.executable, str(ROOT / "docs" / "generate.py"), "--check"],
        capture_output=True,
        text=True,
        env={**os.environ, "ROADLANG_NO_PLUGINS": ""},
    )
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize("page", LINKING, ids=lambda page: page.name)
def test_every_link_within_the_project_leads_somewhere(page: Path) -> None:
    for target in re.findall(r"\]\(([^)\s]+)\)", prose(page)):
        path, _, heading = target.partition("#")
        if path.startswith(("http:", "https:")):
            continue
        linked = page.parent / path if path else page
        assert linked.exists(), f"{page.name} links to {target}"
        if heading and linked.suffix == ".md":
            assert heading in headings(linked), f"{page.name} links to {target}"


def prose(page: Path) -> str:
    """The text of a page without its code blocks."""
    return re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)


def headings(page: Path) -> set[str]:
    """The headings of a page as links name them."""
    words = re.findall(r"^#+ (.*)$", prose(page), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", "-") for text in words}


def test_the_guide_shows_a_plugin_of_every_kind_that_strangers_write() -> None:
    guide = (ROOT / "docs" / "plugins.md").read_text(encoding="utf-8")
    for base in (
        "Extractor",
        "Perturber",
        "Signal",
        "Monitor",
        "DriveSignal",
        "Backend",
        "Controller",
        "Searcher",
    ):
        assert re.search(rf"^class \w+\({base}\)", guide, re.MULTILINE), base


def test_the_guide_explains_the_chicane_plugin_as_it_is() -> None:
    guide = (ROOT / "docs" / "plugins.md").read_text(encoding="utf-8")
    folder = ROOT / "plugins" / "roadlang-chicane"
    for name in ("pyproject.toml", "roadlang_chicane.py"):
        for paragraph in (folder / name).read_text(encoding="utf-8").strip().split("\n\n"):
            assert paragraph.strip("\n") in guide, f"{name}: {paragraph}"


def test_the_reference_has_every_name_of_the_api() -> None:
    page = (ROOT / "docs" / "api.md").read_text(encoding="utf-8")
    for name in api.__all__:
        assert re.search(rf"^### {name}$|`{name}(\[|`)|`@{name}`|^{name}\(", page, re.M), name
    assert "(*args" not in page, "a type that is no function"


def test_the_command_reference_has_every_command_and_no_other() -> None:
    import click

    from roadlang.cli.commands import LazyGroup

    page = (ROOT / "docs" / "commands.md").read_text(encoding="utf-8")
    documented = re.findall(r"^\| `roadlang (\w+)", page, re.MULTILINE)
    commands = LazyGroup("roadlang").list_commands(click.Context(click.Command("roadlang")))
    assert sorted(documented) == sorted(commands)


@pytest.mark.parametrize("page", ["README.md", "docs/paper.md"])
def test_the_paper_is_named(page: str) -> None:
    text = " ".join((ROOT / page).read_text(encoding="utf-8").split())
    assert "*Exploring Flexible Scenario Generation in Godot Simulator*" in text
