"""Errors of paths with the separators of Windows say how to write them on every system."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from roadlang.plugins.registry import Registry
from roadlang.semantics import check_text


@pytest.mark.skipif(sys.platform == "win32", reason="there a backslash separates folders")
@pytest.mark.parametrize("written", [r"maps\base.rl", r"maps\\base.rl", r"maps\table.rl"])
def test_a_path_with_backslashes_is_written_with_slashes(
    written: str, tmp_path: Path, registry: Registry
) -> None:
    (tmp_path / "maps").mkdir()
    name = written.replace("\\", "/").replace("//", "/")
    (tmp_path / name).write_text("param x = 1m\n")
    _, diagnostics = check_text(f'include "{written}"\n', tmp_path / "s.rl", {}, registry)
    [found] = [diagnostic for diagnostic in diagnostics if diagnostic.code == "RL450"]
    assert found.help == (f"write `{name}`: folders are separated by `/` on every system",)
    assert [fix.replacement for fix in found.fixes] == [f'"{name}"']
