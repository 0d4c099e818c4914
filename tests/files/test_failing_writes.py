"""A folder is as it was where a step of writing it fails, and whole where none does."""

from __future__ import annotations

import errno
import json
import os
import shutil
from pathlib import Path
from typing import Any

import pytest

from roadlang.files import transaction
from roadlang.files.transaction import PREFIX, STAGED, is_plain, recover, replace_files

BEFORE = {"a.txt": b"old a", "b.txt": b"old b", "gone.txt": b"old", "manifest.json": b"old m"}
AFTER = {"a.txt": b"new a", "c.txt": b"new c", "manifest.json": b"new m"}


def filled(folder: Path) -> Path:
    for name, content in BEFORE.items():
        (folder / name).write_bytes(content)
    return folder


def contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def write(folder: Path) -> None:
    replace_files(folder, AFTER, ["gone.txt", "never.txt", "a.txt"], "manifest.json")


def test_new_files_replace_old_ones_and_what_is_removed_goes(tmp_path: Path) -> None:
    write(filled(tmp_path))
    assert contents(tmp_path) == {"b.txt": b"old b", **AFTER}


def test_what_ends_the_program_while_old_files_are_removed_leaves_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    remove, calls = shutil.rmtree, []

    def interrupted(room: Path, ignore_errors: bool) -> None:
        calls.append(room)
        if len(calls) == 1:
            next(room.iterdir()).unlink()
            raise KeyboardInterrupt
        remove(room, ignore_errors=ignore_errors)

    monkeypatch.setattr(shutil, "rmtree", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write(filled(tmp_path))
    assert contents(tmp_path) == {"b.txt": b"old b", **AFTER}


@pytest.mark.parametrize("name", ["a.txt", "c.txt", "manifest.json"])
def test_a_folder_is_as_before_when_a_file_cannot_be_put_in_place(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    filled(tmp_path)
    replace = os.replace
    failed: list[str] = []

    def failing(source: Any, target: Any) -> None:
        if Path(target) == tmp_path / name and not failed:
            failed.append(name)
            raise OSError(errno.ENOSPC, "no space left")
        replace(source, target)

    monkeypatch.setattr(os, "replace", failing)
    with pytest.raises(OSError, match="no space left"):
        write(tmp_path)
    assert failed
    assert contents(tmp_path) == BEFORE


def test_a_folder_is_as_before_when_new_files_cannot_be_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    filled(tmp_path)

    def failing(path: Path, content: bytes) -> None:
        raise OSError(errno.ENOSPC, "no space left")

    monkeypatch.setattr(transaction, "write", failing)
    with pytest.raises(OSError, match="no space left"):
        write(tmp_path)
    assert contents(tmp_path) == BEFORE


def test_old_files_are_copied_where_there_are_no_second_names(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As on FAT: hard links fail, and an undone step brings the copy back."""
    filled(tmp_path)

    def no_links(*_: Any) -> None:
        raise OSError(errno.EPERM, "no links here")

    monkeypatch.setattr(os, "link", no_links)
    test_a_folder_is_as_before_when_a_file_cannot_be_put_in_place(
        "manifest.json", tmp_path, monkeypatch
    )


def room(folder: Path, journal: str, steps: list[dict[str, str | None]], **files: bytes) -> None:
    """What a killed process has left."""
    left = folder / f"{PREFIX}left"
    left.mkdir()
    record = {"marker": "manifest.json", "steps": steps}
    (left / journal).write_text(json.dumps(record))
    for name, content in files.items():
        (left / name.replace("_", "-")).write_bytes(content)


STEPS: list[dict[str, str | None]] = [
    {"name": "gone.txt", "new": None, "old": "old-0"},
    {"name": "a.txt", "new": "new-1", "old": "old-1"},
    {"name": "c.txt", "new": "new-2", "old": None},
    {"name": "manifest.json", "new": "new-3", "old": "old-3"},
]
OLD = {"old_0": b"old", "old_1": b"old a", "old_3": b"old m"}


def test_what_was_killed_in_the_middle_is_finished(tmp_path: Path) -> None:
    """`gone.txt` is removed and `a.txt` in its place already."""
    filled(tmp_path)
    (tmp_path / "gone.txt").unlink()
    (tmp_path / "manifest.json").unlink()
    (tmp_path / "a.txt").write_bytes(b"new a")
    room(tmp_path, "journal.json", STEPS, new_2=b"new c", new_3=b"new m", **OLD)
    recover(tmp_path)
    assert contents(tmp_path) == {"b.txt": b"old b", **AFTER}


def test_what_was_killed_while_it_was_undone_is_undone(tmp_path: Path) -> None:
    filled(tmp_path)
    (tmp_path / "gone.txt").unlink()
    (tmp_path / "manifest.json").write_bytes(b"new m")
    (tmp_path / "a.txt").write_bytes(b"new a")
    (tmp_path / "c.txt").write_bytes(b"new c")
    room(tmp_path, "undo.json", STEPS, **OLD)
    recover(tmp_path)
    assert contents(tmp_path) == BEFORE


def test_what_has_no_journal_yet_is_forgotten(tmp_path: Path) -> None:
    filled(tmp_path)
    room(tmp_path, "journal.new", STEPS, new_1=b"new a", **OLD)
    recover(tmp_path)
    assert contents(tmp_path) == BEFORE


@pytest.mark.parametrize(
    "step",
    [{"name": "../a.txt", "new": "new-1", "old": None}, {"name": "a.txt", "new": "/b", "old": None},
     {"name": "a.txt", "new": "sub/b", "old": None}, {"name": "a.txt"},
     {"name": "a.txt", "new": f"{STAGED}1/..", "old": None},
     {"name": "a.txt", "new": f"../{STAGED}1/b", "old": None},
     {"name": "a.txt", "new": f"{STAGED}1/", "old": None},
     {"name": "a.txt", "new": None, "old": ".."}],
    ids=str,
)  # fmt: skip
def test_a_journal_that_names_other_folders_is_refused(step: Any, tmp_path: Path) -> None:
    filled(tmp_path)
    room(tmp_path, "journal.json", [step])
    with pytest.raises(OSError, match="no journal that can be read"):
        recover(tmp_path)


@pytest.mark.parametrize(
    ("name", "plain"),
    [("a.txt", True), ("..a", True), ("", False), (".", False), ("..", False), ("a/b", False),
     ("a\\b", False), ("a\0", False)],
)  # fmt: skip
def test_names_of_files_of_the_folder_itself(name: str, plain: bool) -> None:
    assert is_plain(name) == plain


@pytest.mark.parametrize("what", ["folder", "link to a folder"])
def test_a_folder_is_not_replaced_by_a_file(what: str, tmp_path: Path) -> None:
    (tmp_path / "other").mkdir()
    if what == "folder":
        (tmp_path / "a.txt").mkdir()
    else:
        (tmp_path / "a.txt").symlink_to("other")
    with pytest.raises(OSError, match="it is a folder"):
        replace_files(tmp_path, {"a.txt": b""}, [], None)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.txt", "other"]
