"""Folders of log files: those of processes that have ended are removed, no others."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

import pytest

from roadlang_godot.engines import engine_log


def test_abandoned_folders_are_removed_and_what_cannot_be_is_left(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setattr(engine_log, "_exists", lambda process: process == os.getpid())
    for name in ("7-abandoned", f"{os.getpid()}-ours", "x7-named_by_others"):
        (tmp_path / f"roadlang-godot-{name}").mkdir()
    (tmp_path / "roadlang-godot-7-no_folder").touch()
    new = engine_log.new_log()
    assert new.parent.is_dir()
    assert new.name == "engine.log"
    assert new.parent.name.startswith(f"roadlang-godot-{os.getpid()}-")
    assert {path.name.split("-", 2)[2] for path in tmp_path.iterdir()} - {
        new.parent.name.split("-", 2)[2]
    } == {f"{os.getpid()}-ours", "x7-named_by_others", "7-no_folder"}
