"""Files that are written one by one appear in their folder all at once, or not at all."""

from __future__ import annotations

import ctypes
import errno
import itertools
import os
import stat
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path

import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.files import syncing, transaction
from roadlang.files.staging import staged_set
from roadlang.files.transaction import STAGED

MARKER = "manifest.json"


def everything(marker: Path) -> Iterable[str]:
    """All files of a folder belong to its set."""
    return [path.name for path in marker.parent.iterdir() if not path.name.startswith(".")]


def fill(folder: Path, *names: str) -> None:
    with staged_set(folder, MARKER, everything) as files:
        for name in (*names, MARKER):
            files.add(name, name.encode())


def renew(folder: Path, *names: str) -> None:
    with staged_set(folder, MARKER, lambda _: ()) as files:
        for name in (*names, MARKER):
            files.add(name, b"new")


def fail_inside(folder: Path) -> None:
    with staged_set(folder, MARKER, everything) as files:
        files.add("a", b"other")
        raise OSError("of the caller")


def names_in(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()}


def test_a_new_folder_appears_with_all_its_files(tmp_path: Path) -> None:
    folder = tmp_path / "deep" / "out"
    with staged_set(folder, MARKER, everything) as files:
        files.add("a", b"1")
        files.add(MARKER, b"{}")
        assert not folder.exists()
    assert names_in(folder) == {"a", MARKER}
    assert names_in(folder.parent) == {"out"}
    assert (folder / "a").read_bytes() == b"1"


def test_the_files_of_an_earlier_set_are_replaced(tmp_path: Path) -> None:
    fill(tmp_path, "a", "b")
    with staged_set(tmp_path, MARKER, everything) as files:
        files.add("b", b"new")
        files.add(MARKER, b"{}")
        assert (tmp_path / "a").read_bytes() == b"a"
        assert (tmp_path / "b").read_bytes() == b"b"
    assert names_in(tmp_path) == {"b", MARKER}
    assert (tmp_path / "b").read_bytes() == b"new"


@pytest.mark.parametrize("existing", [False, True], ids=["new folder", "folder with files"])
def test_an_error_leaves_everything_as_it_was(tmp_path: Path, existing: bool) -> None:
    folder = tmp_path / "deep" / "out"
    if existing:
        fill(folder, "a")
    with pytest.raises(OSError, match="of the caller"):
        fail_inside(folder)
    assert (folder / "a").read_bytes() == b"a" if existing else not folder.parent.exists()
    if existing:
        assert names_in(folder) == {"a", MARKER}


def test_a_folder_that_appears_meanwhile_is_filled(tmp_path: Path) -> None:
    folder = tmp_path / "out"
    with staged_set(folder, MARKER, everything) as files:
        files.add("a", b"late")
        files.add(MARKER, b"{}")
        fill(folder, "a", "b")
    assert names_in(folder) == {"a", MARKER}
    assert (folder / "a").read_bytes() == b"late"
    assert names_in(tmp_path) == {"out"}


def test_two_at_a_time_do_not_disturb_each_other(tmp_path: Path) -> None:
    fill(tmp_path, "a")
    with staged_set(tmp_path, MARKER, everything) as first:
        first.add("b", b"first")
        with staged_set(tmp_path, MARKER, everything) as second:
            second.add("c", b"second")
            second.add(MARKER, b"2")
        assert names_in(tmp_path) - {path.name for path in tmp_path.glob(".*")} == {"c", MARKER}
        first.add(MARKER, b"1")
    assert (tmp_path / "b").read_bytes() == b"first"
    assert (tmp_path / MARKER).read_bytes() == b"1"


@pytest.mark.skipif(os.name == "nt", reason="folders cannot be locked there anyway")
@pytest.mark.parametrize("existing", [False, True], ids=["new folder", "folder with files"])
def test_without_locks_two_at_a_time_do_not_disturb_each_other(
    tmp_path: Path, existing: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(handle: int, operation: int) -> None:
        raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))

    monkeypatch.setattr("fcntl.flock", refuse)
    folder = tmp_path / "first"
    other = folder if existing else tmp_path / "second"
    if existing:
        fill(folder, "before")
    with staged_set(folder, MARKER, everything) as files:
        files.add("a", b"a")
        fill(other, "b")
        files.add(MARKER, b"{}")
    assert names_in(folder) == {"a", MARKER}
    assert existing or names_in(other) == {"b", MARKER}


@pytest.mark.parametrize(("count", "together"), [(2, True), (100, True), (100, False)])
def test_contents_that_the_disk_did_not_take_are_reported(
    tmp_path: Path, count: int, together: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The system tells so when a file is synchronized, long after it was written."""
    original = os.fsync

    def fail_on_files(handle: int) -> None:
        if stat.S_ISREG(os.fstat(handle).st_mode):
            raise OSError(errno.EIO, os.strerror(errno.EIO))
        original(handle)

    def fail(handle: int) -> int:
        ctypes.set_errno(errno.EIO)
        return -1

    monkeypatch.setattr(os, "fsync", fail_on_files)
    monkeypatch.setattr(syncing, "_syncfs", lambda: fail if together else None)
    with pytest.raises(DiagnosticError) as refused:
        fill(tmp_path / "out", *map(str, range(count)))
    assert refused.value.diagnostics[0].code == "RL460"
    assert not names_in(tmp_path)


@pytest.mark.parametrize(("count", "result", "alone"), [(100, 0, 0), (100, None, 101), (2, 0, 3)])
def test_many_files_are_made_safe_together_where_the_system_can(
    tmp_path: Path, count: int, result: int | None, alone: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    synced: list[int] = []
    original = os.fsync

    def note(handle: int) -> None:
        synced.append(stat.S_ISREG(os.fstat(handle).st_mode))
        original(handle)

    monkeypatch.setattr(os, "fsync", note)
    call = None if result is None else lambda handle: result
    monkeypatch.setattr(syncing, "_syncfs", lambda: call)
    fill(tmp_path / "out", *map(str, range(count)))
    assert len(names_in(tmp_path / "out")) == count + 1
    assert sum(synced) == alone


@pytest.mark.parametrize("names", [("a", "b", "c"), ()])
def test_whoever_sees_the_marker_sees_all_files_of_its_set(
    tmp_path: Path, names: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also while a set that is in place is taken back, because Ctrl-C came then."""
    fill(tmp_path, "a", "b")
    before = {name: (tmp_path / name).read_bytes() for name in names_in(tmp_path)}
    marker, replace = tmp_path / MARKER, os.replace
    seen: list[bool] = []

    def replace_and_look(source: str | Path, target: str | Path) -> None:
        if Path(target).parent == tmp_path and Path(target) != marker:
            seen.append(marker.exists())
        replace(source, target)

    def interrupt(folder: Path) -> None:
        if folder == tmp_path and marker.exists() and marker.read_bytes() == b"new":
            monkeypatch.setattr(transaction, "sync_folder", lambda folder: None)
            raise KeyboardInterrupt

    monkeypatch.setattr(transaction, "sync_folder", interrupt)
    monkeypatch.setattr(os, "replace", replace_and_look)
    with pytest.raises(KeyboardInterrupt):
        renew(tmp_path, *names)
    assert len(seen) >= len(names)
    assert not any(seen)
    assert {name: (tmp_path / name).read_bytes() for name in names_in(tmp_path)} == before


def test_a_file_in_place_of_the_folder_is_reported(tmp_path: Path) -> None:
    (tmp_path / "out").write_text("mine")
    with pytest.raises(DiagnosticError) as refused:
        fill(tmp_path / "out", "a")
    assert refused.value.diagnostics[0].code == "RL460"
    assert "`out` is a file, not a folder" in refused.value.diagnostics[0].message
    assert (tmp_path / "out").read_text() == "mine"


KILLED = """
import os, signal, sys
from pathlib import Path
from roadlang.files import syncing, transaction
from roadlang.files.staging import staged_set
with staged_set(Path(sys.argv[1]), "manifest.json", lambda marker: ()) as files:
    files.add("a", b"half")
    os.kill(os.getpid(), signal.SIGKILL)
"""


@pytest.mark.skipif(os.name == "nt", reason="no SIGKILL")
@pytest.mark.parametrize("existing", [False, True], ids=["new folder", "folder with files"])
def test_what_a_killed_process_gathered_is_nowhere_and_is_removed(
    tmp_path: Path, existing: bool
) -> None:
    folder = tmp_path / "out"
    if existing:
        fill(folder, "a")
    done = subprocess.run([sys.executable, "-c", KILLED, str(folder)], check=False)
    assert done.returncode < 0
    if existing:
        assert (folder / "a").read_bytes() == b"a"
        assert (folder / MARKER).exists()
    else:
        assert not folder.exists()
    base = folder if existing else tmp_path
    assert len(list(base.glob(f"{STAGED}*"))) == 1
    fill(folder, "c")
    assert not list(base.glob(f"{STAGED}*"))
    assert {"c", MARKER} <= names_in(folder)


@pytest.mark.parametrize("name", ["../out.txt", "a/b.txt", "", ".."])
def test_names_that_lead_out_of_the_folder_are_refused(tmp_path: Path, name: str) -> None:
    with pytest.raises(ValueError, match="is not the name of a file in a folder"):
        fill(tmp_path / "set", name)
    assert list(tmp_path.iterdir()) == []


def test_files_of_a_staging_folder_are_moved_and_the_rest_of_it_is_removed(tmp_path: Path) -> None:
    folder = tmp_path / "out"
    with staged_set(folder, MARKER, everything) as files:
        side = files.staging_folder()
        first, second = side.stage(b"1"), side.stage(b"2")
        assert first != second
        files.add("a", second)
        files.add(MARKER, b"{}")
    assert names_in(folder) == {"a", MARKER}
    assert (folder / "a").read_bytes() == b"2"


def test_a_staging_folder_keeps_what_a_lost_process_of_the_same_number_wrote(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with staged_set(tmp_path / "out", MARKER, everything) as files:
        side = files.staging_folder()
        monkeypatch.setattr("roadlang.files.staging._numbers", itertools.count())
        first = side.stage(b"1")
        monkeypatch.setattr("roadlang.files.staging._numbers", itertools.count())
        assert side.stage(b"2") != first
        assert Path(first).read_bytes() == b"1"


def lay_in_a_lost_room(folder: Path) -> None:
    with staged_set(folder, MARKER, everything) as files:
        side = files.staging_folder()
        side.path.rmdir()
        side.stage(b"1")


def test_a_staging_folder_that_cannot_be_written_is_reported(tmp_path: Path) -> None:
    folder = tmp_path / "out"
    with pytest.raises(DiagnosticError, match="RL460"):
        lay_in_a_lost_room(folder)
    assert not list(tmp_path.iterdir())
