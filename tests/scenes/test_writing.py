"""Files are written whole, all of them or none."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.scenes.writing import write_all


def test_folders_are_made_and_files_written(tmp_path: Path) -> None:
    write_all(tmp_path / "out", {"a.json": "{}", "pictures/b.svg": b"<svg/>"})
    assert (tmp_path / "out/a.json").read_text() == "{}"
    assert (tmp_path / "out/pictures/b.svg").read_bytes() == b"<svg/>"


def test_one_that_cannot_be_written_leaves_none(tmp_path: Path) -> None:
    (tmp_path / "taken").write_text("a file, not a folder")
    with pytest.raises(DiagnosticError) as caught:
        write_all(tmp_path, {"a.json": "{}", "taken/b.svg": "<svg/>"})
    assert caught.value.diagnostics[0].code == "RL460"
    assert sorted(os.listdir(tmp_path)) == ["taken"]


def test_what_was_there_stays_until_all_is_ready(tmp_path: Path) -> None:
    (tmp_path / "a.json").write_text("old")
    (tmp_path / "taken").write_text("")
    with pytest.raises(DiagnosticError):
        write_all(tmp_path, {"a.json": "new", "taken/b": ""})
    assert (tmp_path / "a.json").read_text() == "old"
