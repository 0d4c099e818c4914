"""Files that were staged in the folder that they are for are moved once, and are not lost where
the process that moves them is."""

from __future__ import annotations

import errno
import json
import os
from pathlib import Path
from typing import Any

import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.files.locking import folder_lock
from roadlang.files.staging import staging_folder
from roadlang.files.transaction import PREFIX, STAGED, recover
from roadlang.files.writing import write_all

CONTENTS = {"a.txt": b"new a", "b.txt": b"new b"}


def files_of(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def write_staged(folder: Path) -> None:
    with staging_folder(folder) as staging:
        write_all(folder, {name: staging.stage(content) for name, content in CONTENTS.items()})


def test_a_staged_file_is_renamed_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    moved: list[tuple[str, str]] = []
    replace = os.replace

    def note(source: str | Path, target: str | Path) -> None:
        moved.append((os.fspath(source), os.fspath(target)))
        replace(source, target)

    def refuse(*_: Any) -> None:
        raise AssertionError

    monkeypatch.setattr(os, "replace", note)
    monkeypatch.setattr(os, "rename", refuse)
    write_staged(tmp_path)
    assert files_of(tmp_path) == CONTENTS
    ours = [pair for pair in moved if Path(pair[1]).parent == tmp_path]
    assert len(ours) == len(CONTENTS)
    assert all(Path(source).parent.name.startswith(STAGED) for source, _ in ours)


@pytest.mark.parametrize("by", ["recovery", "staging"])
@pytest.mark.parametrize("name", ["a", "z"], ids=["listed before", "listed after"])
def test_what_a_journal_awaits_is_put_in_place_before_its_staging_folder_is_removed(
    by: str, name: str, tmp_path: Path
) -> None:
    staged, room = tmp_path / f"{STAGED}1-0", tmp_path / f"{PREFIX}{name}"
    staged.mkdir()
    room.mkdir()
    (staged / "1-0").write_bytes(b"new a")
    (staged / "1-1").write_bytes(b"not added")
    step = {"name": "a.txt", "new": f"{staged.name}/1-0", "old": None}
    (room / "journal.json").write_text(json.dumps({"marker": None, "steps": [step]}))
    if by == "staging":
        with staging_folder(tmp_path):
            assert (tmp_path / "a.txt").read_bytes() == b"new a"
    else:
        with folder_lock(tmp_path):
            recover(tmp_path)
    assert files_of(tmp_path) == {"a.txt": b"new a"}


def test_a_set_that_can_neither_be_put_in_place_nor_be_undone_is_finished_later(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    replace = os.replace

    def fail(source: str | Path, target: str | Path) -> None:
        if Path(target).name not in ("a.txt", "journal.json"):
            raise OSError(errno.EROFS, os.strerror(errno.EROFS))
        replace(source, target)

    with monkeypatch.context() as patched:
        patched.setattr(os, "replace", fail)
        with pytest.raises(DiagnosticError, match="RL460"):
            write_staged(tmp_path)
    assert list(tmp_path.glob(f"{STAGED}*"))
    with folder_lock(tmp_path):
        recover(tmp_path)
    assert files_of(tmp_path) == CONTENTS


def test_a_staging_folder_goes_while_another_process_writes(tmp_path: Path) -> None:
    room = tmp_path / f"{PREFIX}other"
    room.mkdir()
    step = {"name": "a.txt", "new": f"{STAGED}other-0/1-0", "old": None}
    (room / "journal.json").write_text(json.dumps({"marker": None, "steps": [step]}))
    with staging_folder(tmp_path):
        pass
    assert not list(tmp_path.glob(f"{STAGED}*"))
    assert room.exists()
