"""Writers that are killed at every step that changes a folder. Run as a program by the tests.

    python killed_writers.py FOLDER HOW [staged]

A child process is killed (SIGKILL) before its k-th call that changes something, for every k, and
in a second sweep its recovery is killed in the same way. After each, FOLDER is looked at.
"""

from __future__ import annotations

import errno
import hashlib
import json
import os
import shutil
import signal
import sys
from collections.abc import Callable
from pathlib import Path

from roadlang.diagnostics import DiagnosticError
from roadlang.files import writing
from roadlang.files.locking import folder_lock
from roadlang.files.staging import staging_folder
from roadlang.files.transaction import recover

reached: list[int] = []
CHANGES = ("replace", "unlink", "link", "symlink", "mkdir", "rmdir", "open", "fsync")
OLD = {"scene-0.json": b"old 0", "scene-1.json": b"old 1", "scene-2.json": b"old 2"}
NEW = {"scene-0.json": b"new 0" * 1000, "sheet.svg": b"new sheet"}
FOREIGN = {"notes.txt": b"mine", ".hidden": b"mine too"}


def manifest(contents: dict[str, bytes]) -> bytes:
    digests = {name: hashlib.sha256(data).hexdigest() for name, data in contents.items()}
    return json.dumps(digests).encode()


def write(folder: Path, contents: dict[str, bytes]) -> None:
    whole = {**contents, "manifest.json": manifest(contents)}
    writing.write_set(folder, whole, "manifest.json", lambda path: json.loads(path.read_text()))


def write_staged(folder: Path, contents: dict[str, bytes]) -> None:
    """As `write`, of files that workers have staged in the folder."""
    with staging_folder(folder) as staging:
        whole = {**contents, "manifest.json": manifest(contents)}
        places = {name: staging.stage(data) for name, data in whole.items()}
        writing.write_set(
            folder, places, "manifest.json", lambda path: json.loads(path.read_text())
        )


def before_call(number: int, act: Callable[[], None]) -> None:
    """Have `act` done before the `number`-th of all calls that change something."""
    calls = iter(range(10**6))

    def guarded(name: str) -> None:
        original = getattr(os, name)

        def call(*arguments: object, **options: object) -> object:
            # What a loss of power would need is not tried, and takes most of the time: whoever is
            # killed before such a call is killed before the next one.
            if name == "fsync" and act is kill:
                return None
            if next(calls) == number:
                reached.append(number)
                act()
            return None if name == "fsync" else original(*arguments, **options)

        setattr(os, name, call)

    for name in CHANGES:
        guarded(name)


def kill() -> None:
    os.kill(os.getpid(), signal.SIGKILL)


def fail() -> None:
    raise OSError(errno.EIO, "the disk is on fire")


def in_child(work: Callable[[], None]) -> int:
    """The exit code of `work` in a process of its own: 0 where nothing stopped it, negative
    where it was killed."""
    child = os.fork()
    if child == 0:
        try:
            work()
        except (OSError, DiagnosticError):
            os._exit(3)
        os._exit(4 if reached else 0)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def files_of(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}


def prepare(folder: Path) -> None:
    shutil.rmtree(folder, ignore_errors=True)
    write(folder, OLD)
    for name, data in FOREIGN.items():
        (folder / name).write_bytes(data)


def recovered(folder: Path) -> None:
    with folder_lock(folder):
        recover(folder)


def check_at_kill(folder: Path) -> None:
    """Foreign files are there; where a manifest is, all that it names is there and whole."""
    found = files_of(folder)
    assert FOREIGN.items() <= found.items(), found
    if "manifest.json" in found:
        named = json.loads(found["manifest.json"])
        for name, digest in named.items():
            assert hashlib.sha256(found[name]).hexdigest() == digest, name


def check_recovered(folder: Path) -> str:
    """All is old, or all is new, and nothing else is left."""
    found = files_of(folder)
    assert not any(path.is_dir() for path in folder.iterdir())
    for word, contents in (("old", OLD), ("new", NEW)):
        whole = {**contents, "manifest.json": manifest(contents), **FOREIGN}
        if found == whole:
            return word
    raise AssertionError(sorted(found))


def sweep(folder: Path, first: Callable[[], None], second: Callable[[], None] | None) -> set[str]:
    """What is found after a writer is stopped by `first` at each call, and then its recovery, or
    what it does after a failure, by `second` at each call."""
    outcomes: set[str] = set()
    for number in range(10**6):
        for later in range(10**6):
            prepare(folder)

            def work(number: int = number) -> None:
                before_call(number, first)
                write_new(folder, NEW)

            finished = in_child(work) == 0
            check_at_kill(folder)
            if finished or second is None:
                break

            def again(later: int = later) -> None:
                before_call(later, second)
                recovered(folder)

            recovery_finished = in_child(again) == 0
            check_at_kill(folder)
            if recovery_finished:
                break
            recovered(folder)
            outcomes.add(check_recovered(folder))
        recovered(folder)
        outcomes.add(check_recovered(folder))
        if finished:
            return outcomes
    raise AssertionError


def fail_then_kill(folder: Path) -> set[str]:
    """A rename fails, and while the writer undoes what it did it is killed at each call."""
    outcomes: set[str] = set()
    for number in range(10**6):
        for later in range(number + 1, 10**6):
            prepare(folder)

            def work(number: int = number, later: int = later) -> None:
                before_call(later, kill)
                before_call(number, fail)
                write_new(folder, NEW)

            code = in_child(work)
            check_at_kill(folder)
            recovered(folder)
            outcomes.add(check_recovered(folder))
            if code >= 0:
                break
        if code == 0:
            return outcomes
    raise AssertionError


if __name__ == "__main__":
    os.fsync = lambda fd: None
    where = Path(sys.argv[1]) / "out"
    mode = sys.argv[2]
    write_new = write_staged if "staged" in sys.argv[3:] else write
    if mode == "fail":
        outcomes = fail_then_kill(where)
    else:
        outcomes = sweep(where, kill, kill if mode == "kill recovery" else None)
    sys.stdout.write(" ".join(sorted(outcomes)) + "\n")
