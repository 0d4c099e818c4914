"""The documentation site: every page has its place in it, and it builds without a warning."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from roadlang.cli.main import run

ROOT = Path(__file__).parents[2]
NAV = (ROOT / "mkdocs.yml").read_text(encoding="utf-8").partition("\nnav:")[2].partition("\n\n")[0]


def test_every_page_has_its_place_in_the_navigation() -> None:
    listed = re.findall(r"\S+\.md", NAV)
    pages = {path.relative_to(ROOT / "docs").as_posix() for path in (ROOT / "docs").rglob("*.md")}
    assert pages <= set(listed)
    assert len(listed) == len(set(listed))


def test_scene_files_are_colored() -> None:
    pygments = pytest.importorskip("pygments")
    sys.path.insert(0, str(ROOT / "docs" / "site"))
    try:
        from lexer import RoadlangLexer  # type: ignore[import-not-found]
    finally:
        sys.path.pop(0)
    text = (ROOT / "examples" / "hairpin.rl").read_text(encoding="utf-8")
    tokens = list(pygments.lex(text, RoadlangLexer()))
    kinds = {value: str(kind) for kind, value in tokens}
    assert "".join(value for _, value in tokens) == text
    assert kinds["require"] == "Token.Keyword.Declaration"
    assert kinds["always"] == "Token.Operator.Word"
    assert kinds["0.5m/px"] == "Token.Literal.Number"


@pytest.mark.slow
def test_the_site_builds_without_a_warning(tmp_path: Path) -> None:
    pytest.importorskip("mkdocs")
    done = subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "--strict", "-d", str(tmp_path / "site")],
        cwd=ROOT,
        env={**os.environ, "NO_MKDOCS_2_WARNING": "1"},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert "WARNING" not in done.stderr
    assert '<span class="kd">road</span>' in (tmp_path / "site/tutorial/index.html").read_text()
    assert (tmp_path / "site/search/search_index.json").stat().st_size > 100_000
    for page in (tmp_path / "site").rglob("*.html"):
        if page.name != "404.html":
            check_links(page)


def check_links(page: Path) -> None:
    """Every relative link and picture of a built page leads to a file of the site."""
    text = page.read_text(encoding="utf-8")
    for target in re.findall(r'(?:href|src)="([^"#?]+)["#?]', text):
        if not re.match(r"\w+:|//", target):
            path = page.parent / target
            assert path.is_file() or (path / "index.html").is_file(), f"{page}: {target}"


def test_the_pictures_of_the_gallery_are_there_small_and_made_of_scenes_that_check() -> None:
    sys.path.insert(0, str(ROOT / "docs" / "site"))
    try:
        from gallery import PICTURES  # type: ignore[import-not-found]
    finally:
        sys.path.pop(0)
    sizes = [picture.path.stat().st_size for picture in PICTURES]
    assert len(sizes) == 12
    assert max(sizes) <= 120_000
    assert sum(sizes) <= 1_200_000
    assert {path.name for path in PICTURES[0].path.parent.iterdir()} == {
        picture.path.name for picture in PICTURES
    }
    for scene in {picture.scene for picture in PICTURES}:
        assert run(["check", str(ROOT / "examples" / f"{scene}.rl")]) == 0
