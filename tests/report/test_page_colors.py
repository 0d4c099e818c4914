"""The page of a report, whose style and scripts import nothing, has the colors of the figures."""

from __future__ import annotations

import re
from pathlib import Path

from roadlang.drive.robustness_colors import OTHER
from roadlang.report import page_text
from roadlang_standard.svg import palette

PAGE = Path(page_text.__file__).parent / "page"


def test_agents_have_the_same_colors_on_the_page_as_in_figures() -> None:
    script = (PAGE / "viewer.js").read_text(encoding="utf-8")
    listed = re.search(r"const COLORS = \[(.*?)\];", script)
    assert listed is not None
    assert tuple(re.findall(r'"(#\w+)"', listed[1])) == palette.AGENTS


def test_other_paths_have_the_same_color_on_the_page_as_in_figures() -> None:
    style = (PAGE / "page.css").read_text(encoding="utf-8")
    assert f"--other: {OTHER}" in style
