"""Files are written whole, all of a set or none, however the writer ends."""

from __future__ import annotations

import json
import multiprocessing
import os
import resource
import subprocess
import sys
from multiprocessing.synchronize import Event
from pathlib import Path
from typing import Any

import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.files.locking import folder_lock
from roadlang.files.transaction import recover
from roadlang.files.writing import replace_file, write_all, write_file, write_set

KILLED = Path(__file__).with_name("killed_writers.py")


def names_in(path: Path) -> list[str]:
    names: list[str] = json.loads(path.read_text())
    return names


def write(folder: Path, **contents: str) -> None:
    """A set whose marker names its files."""
    files = {name.replace("_", "."): text for name, text in contents.items()}
    write_set(folder, {**files, "marker": json.dumps(list(files))}, "marker", names_in)


def files_of(folder: Path) -> dict[str, str]:
    return {path.name: path.read_text() for path in folder.iterdir() if path.is_file()}


@pytest.mark.parametrize("stopped", ["kill", "fail"])
@pytest.mark.parametrize("how", [(), ("staged",)], ids=["contents", "staged"])
def test_a_writer_stopped_at_any_moment_leaves_the_old_set_or_the_new_one(
    stopped: str, how: tuple[str, ...], tmp_path: Path
) -> None:
    done = subprocess.run(
        [sys.executable, str(KILLED), str(tmp_path), stopped, *how], capture_output=True, text=True
    )
    assert done.stdout == "new old\n", done.stderr


@pytest.mark.slow
@pytest.mark.parametrize("how", [(), ("staged",)], ids=["contents", "staged"])
def test_a_recovery_that_is_killed_as_well_is_made_good(
    how: tuple[str, ...], tmp_path: Path
) -> None:
    done = subprocess.run(
        [sys.executable, str(KILLED), str(tmp_path), "kill recovery", *how],
        capture_output=True,
        text=True,
    )
    assert done.stdout == "new old\n", done.stderr


def test_the_folder_is_made(tmp_path: Path) -> None:
    write_all(tmp_path / "a/b", {"x.json": "{}", "y.svg": b"<svg/>"})
    assert files_of(tmp_path / "a/b") == {"x.json": "{}", "y.svg": "<svg/>"}


def test_a_folder_that_was_made_for_a_write_that_fails_goes_again(tmp_path: Path) -> None:
    with pytest.raises(DiagnosticError, match="RL460"):
        write_all(tmp_path / "a/b", {"n" * 300: ""})
    assert not (tmp_path / "a").exists()


@pytest.mark.parametrize("folder", ["a", "a/b"])
def test_an_empty_folder_that_was_there_stays_where_a_write_fails(
    folder: str, tmp_path: Path
) -> None:
    (tmp_path / "a").mkdir()
    with pytest.raises(DiagnosticError, match="RL460"):
        write_all(tmp_path / folder, {"n" * 300: ""})
    assert list(tmp_path.rglob("*")) == [tmp_path / "a"]


def test_files_of_the_older_set_go_and_all_others_stay(tmp_path: Path) -> None:
    write(tmp_path, a_json="1", b_json="1", c_json="1")
    (tmp_path / "notes.txt").write_text("mine")
    (tmp_path / "c.json").unlink()
    write(tmp_path, a_json="2")
    assert files_of(tmp_path) == {"a.json": "2", "marker": '["a.json"]', "notes.txt": "mine"}


def test_the_older_set_cannot_name_files_elsewhere(tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("mine")
    folder = tmp_path / "out"
    write(folder, a_json="1")
    (folder / "marker").write_text(json.dumps(["../secret", str(tmp_path / "secret"), ".."]))
    write(folder, a_json="2")
    assert (tmp_path / "secret").read_text() == "mine"


@pytest.mark.parametrize("name", ["../a", "a/b", "", "..", "/a"])
def test_names_are_those_of_files_in_the_folder(name: str, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="not the name of a file"):
        write_all(tmp_path, {name: ""})


def make_folder(path: Path) -> None:
    path.mkdir()


def make_pipe(path: Path) -> None:
    os.mkfifo(path)


def make_link_to_a_folder(path: Path) -> None:
    path.symlink_to("/")


@pytest.mark.parametrize("make", [make_folder, make_pipe, make_link_to_a_folder])
def test_what_is_no_file_is_not_replaced_and_nothing_else_either(make: Any, tmp_path: Path) -> None:
    write(tmp_path, a_json="1", b_json="1")
    before = files_of(tmp_path)
    make(tmp_path / "c.json")
    with pytest.raises(
        DiagnosticError,
        match=r"RL460\]: cannot write `.*c\.json`: it is a (pipe, not a file|folder)\n",
    ):
        write(tmp_path, a_json="2", b_json="2", c_json="2")
    assert {name: (tmp_path / name).read_text() for name in before} == before
    assert not list(tmp_path.glob(".*"))


def test_a_link_is_replaced_and_not_followed(tmp_path: Path) -> None:
    (tmp_path / "elsewhere").write_text("mine")
    folder = tmp_path / "out"
    folder.mkdir()
    (folder / "a.json").symlink_to(tmp_path / "elsewhere")
    write(folder, a_json="1")
    assert (tmp_path / "elsewhere").read_text() == "mine"
    assert not (folder / "a.json").is_symlink()


def full_disk(folder: Path, bytes_: int) -> None:
    resource.setrlimit(resource.RLIMIT_FSIZE, (bytes_, bytes_))
    try:
        write(folder, a_json="2" * 3000, b_json="2" * 3000)
    except DiagnosticError as error:
        os._exit(0 if error.diagnostics[0].code == "RL460" else 1)
    os._exit(2)


@pytest.mark.parametrize("room", [0, 100, 2999])
def test_a_full_disk_leaves_the_old_set(room: int, tmp_path: Path) -> None:
    write(tmp_path, a_json="1")
    before = files_of(tmp_path)
    child = multiprocessing.get_context("spawn").Process(target=full_disk, args=(tmp_path, room))
    child.start()
    child.join()
    assert child.exitcode == 0
    assert files_of(tmp_path) == before
    assert not list(tmp_path.glob(".*"))


def test_what_killed_writers_left_is_removed(tmp_path: Path) -> None:
    (tmp_path / ".roadlang-abc").mkdir()
    (tmp_path / ".roadlang-abc/new-0").write_text("half")
    (tmp_path / ".roadlang-def").write_text("half")
    write_all(tmp_path, {"a": ""})
    assert os.listdir(tmp_path) == ["a"]


@pytest.mark.parametrize("name", ["../../secret", "/etc/passwd"])
def test_a_journal_cannot_name_files_elsewhere(name: str, tmp_path: Path) -> None:
    room = tmp_path / "out" / ".roadlang-abc"
    room.mkdir(parents=True)
    (room / "new-0").write_text("wrong")
    step = {"name": name, "new": "new-0", "old": None}
    (room / "journal.json").write_text(json.dumps({"marker": None, "steps": [step]}))
    with pytest.raises(DiagnosticError, match="RL460"):
        write_all(tmp_path / "out", {"a": ""})
    assert not (tmp_path / "secret").exists()


def test_another_file_in_the_place_of_the_marker_is_not_replaced(tmp_path: Path) -> None:
    from roadlang.session.manifest_files import files_named_in

    for text in ('{"name": "my web page"}', "[]", '{"schema": "roadlang.scene/2", "files": []}'):
        (tmp_path / "manifest.json").write_text(text)
        with pytest.raises(DiagnosticError, match="was not written by roadlang"):
            write_set(tmp_path, {"manifest.json": ""}, "manifest.json", files_named_in)
        assert (tmp_path / "manifest.json").read_text() == text


def hold_lock(folder: Path, held: Event, release: Event) -> None:
    with folder_lock(folder):
        held.set()
        release.wait()


def test_writers_of_one_folder_wait_for_each_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fcntl = pytest.importorskip("fcntl")
    context = multiprocessing.get_context("spawn")
    held, release = context.Event(), context.Event()
    holder = context.Process(target=hold_lock, args=(tmp_path, held, release))
    holder.start()
    held.wait()
    lock, waited = fcntl.flock, list[dict[str, str]]()

    def watched_lock(handle: int, how: int) -> None:
        """Lets the other go as soon as it is waited for."""
        try:
            lock(handle, how | fcntl.LOCK_NB)
        except BlockingIOError:
            waited.append(files_of(tmp_path))
            release.set()
            lock(handle, how)

    monkeypatch.setattr(fcntl, "flock", watched_lock)
    write_all(tmp_path, {"a": "x"})
    release.set()
    holder.join()
    assert waited == [{}], "nothing is written until the lock is free"
    assert files_of(tmp_path) == {"a": "x"}


def test_a_file_of_the_user_keeps_its_permissions_and_the_links_to_it(tmp_path: Path) -> None:
    (tmp_path / "scene.rl").write_text("old")
    (tmp_path / "scene.rl").chmod(0o640)
    (tmp_path / "link.rl").symlink_to("scene.rl")
    replace_file(tmp_path / "link.rl", "new")
    assert (tmp_path / "scene.rl").read_text() == "new"
    assert (tmp_path / "link.rl").is_symlink()
    assert (tmp_path / "scene.rl").stat().st_mode & 0o777 == 0o640
    with pytest.raises(DiagnosticError, match="RL927"):
        replace_file(tmp_path / "nope.rl", "")


def test_permissions_of_new_files_follow_the_umask(tmp_path: Path) -> None:
    before = os.umask(0o027)
    try:
        write_file(tmp_path / "a", "")
    finally:
        os.umask(before)
    assert (tmp_path / "a").stat().st_mode & 0o777 == 0o640


def test_recovering_a_clean_folder_changes_nothing(tmp_path: Path) -> None:
    write(tmp_path, a_json="1")
    before = files_of(tmp_path)
    recover(tmp_path)
    assert files_of(tmp_path) == before


@pytest.mark.parametrize(
    ("error", "reason"),
    [(OSError(28, "No space left on device"), "no space left on device"),
     (TimeoutError(), "timeouterror")],
)  # fmt: skip
def test_a_file_that_cannot_be_replaced_stays_and_the_reason_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, error: OSError, reason: str
) -> None:
    def refuse(handle: int) -> None:
        raise error

    (tmp_path / "a.rl").write_text("before")
    monkeypatch.setattr(os, "fsync", refuse)
    with pytest.raises(DiagnosticError, match=reason):
        replace_file(tmp_path / "a.rl", "after")
    assert (tmp_path / "a.rl").read_text() == "before"
    assert [path.name for path in tmp_path.iterdir()] == ["a.rl"]
