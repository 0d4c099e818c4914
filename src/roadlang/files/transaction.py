"""Several files of a folder replaced together, so that a kill at any moment can be made good.

New contents and the files that they replace are gathered in a separate folder, `.roadlang-*`,
beside the files. Its journal is what decides: before there is one, nothing has happened;
`journal.json` says that the new files are to be put in place, `undo.json` that the old ones are.
Either is carried out from the beginning as often as it takes.
"""

from __future__ import annotations

import contextlib
import ctypes
import errno
import json
import os
import re
import shutil
import sys
import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import cache
from pathlib import Path

from .locking import may_be_held
from .reading import UnreadableFile, refuse_others

PREFIX = ".roadlang-"
STAGED = f"{PREFIX}new-"
"""Begins the names of folders in which files are gathered under a lock; the names of those of
transactions have no second hyphen."""
_JOURNAL, _UNDO = "journal.json", "undo.json"
_MANY = 32
_TELLS_OF_ERRORS = (5, 12)
"""The version of Linux from which on `syncfs` does, through layered file systems too."""


@dataclass(frozen=True)
class _FileStep:
    """A file of the folder, and what stands for it in the transaction's own folder."""

    name: str
    new: str | None
    """None: the file is removed"""
    old: str | None
    """None: the file was not there"""


def replace_files(
    folder: Path, contents: Mapping[str, bytes | Path], removed: Iterable[str], marker: str | None
) -> None:
    """Write `contents` by name and remove `removed`, all or nothing. Of a path the file is moved.

    While it happens `marker` is not there: where it is, all files are those that belong to it.
    Raises `OSError` with the folder as it was before. The caller holds the lock of the folder.
    """
    _refuse_non_files(folder, contents)
    room = Path(tempfile.mkdtemp(prefix=PREFIX, dir=folder))
    try:
        steps = _gathered(folder, room, contents, removed, marker)
        write(room / "journal.new", _as_json(steps, marker))
        sync_folder(room)
        os.replace(room / "journal.new", room / _JOURNAL)
    except BaseException:
        _dissolve(room)
        raise
    try:
        _put_in_place(folder, room, steps, marker)
    except BaseException:
        os.replace(room / _JOURNAL, room / _UNDO)
        _undo(folder, room, steps, marker)
        _dissolve(room)
        raise
    _dissolve(room)


def recover(folder: Path) -> None:
    """Finish, or undo, what killed processes have begun, and remove what they left.

    The caller holds the lock of the folder. Raises `OSError`.
    """
    for room in sorted(folder.glob(f"{PREFIX}*")):
        if room.name.startswith(STAGED) and may_be_held(room):
            continue  # somebody gathers files there
        if not _is_folder(room):
            with contextlib.suppress(OSError):
                room.unlink()
            continue
        for journal, carry_out in ((_UNDO, _undo), (_JOURNAL, _put_in_place)):
            if (room / journal).exists():
                carry_out(folder, room, *_from_json((room / journal).read_bytes()))
                break
        _dissolve(room)


def _dissolve(room: Path) -> None:
    """Remove a transaction's folder, its journal first: without one it means nothing."""
    for name in (_JOURNAL, _UNDO):
        with contextlib.suppress(OSError):
            (room / name).unlink()
    remove_tree(room)


def remove_tree(room: Path) -> None:
    """Remove a folder with all that is in it, as far as the system lets us."""
    try:
        shutil.rmtree(room, ignore_errors=True)
    except BaseException:  # SIGTERM or Ctrl-C in the middle of it
        shutil.rmtree(room, ignore_errors=True)
        raise


def is_plain(name: str) -> bool:
    """Whether a name means a file of the folder itself."""
    return name not in ("", ".", "..") and not set(name) & {"/", "\\", "\0"}


def _is_folder(path: Path) -> bool:
    return path.is_dir() and not path.is_symlink()


def _refuse_non_files(folder: Path, names: Iterable[str]) -> None:
    """A folder or a device is not replaced, nor what a link to one stands for."""
    for name in names:
        target = os.path.join(folder, name)
        if os.path.exists(target):
            try:
                refuse_others(os.stat(target))
            except UnreadableFile as fault:
                raise OSError(errno.EINVAL, fault.reason, target) from None


def _gathered(
    folder: Path,
    room: Path,
    contents: Mapping[str, bytes | Path],
    removed: Iterable[str],
    marker: str | None,
) -> list[_FileStep]:
    """Write the new contents, keep the old files, and list the steps, the marker's last."""
    names = sorted(contents, key=lambda name: name == marker)
    deleted = [
        name
        for name in dict.fromkeys(removed)
        if is_plain(name) and name not in contents and (folder / name).is_file()
    ]
    steps = []
    for number, name in enumerate([*deleted, *names]):
        new = f"new-{number}" if name in contents else None
        if new is not None:
            _place(os.path.join(room, new), contents[name])
        steps.append(_FileStep(name, new, _backup(folder, name, room, number)))
    sync_of_many([room / step.new for step in steps if step.new is not None])
    return steps


def _backup(folder: Path, name: str, room: Path, number: int) -> str | None:
    """A second name for what is there now, or a copy where the file system has no such names."""
    if not os.path.lexists(os.path.join(folder, name)):
        return None
    target, copy = folder / name, room / f"old-{number}"
    try:
        if target.is_symlink():
            os.symlink(os.readlink(target), copy)
        else:
            os.link(target, copy)
    except OSError:
        shutil.copy2(target, copy, follow_symlinks=False)
    return copy.name


def _put_in_place(folder: Path, room: Path, steps: list[_FileStep], marker: str | None) -> None:
    last = steps[-1] if steps else None
    if last is not None and last.name == marker and last.new and (room / last.new).exists():
        _remove(folder / marker)
        sync_folder(folder)
    for step in steps:
        if step is last:
            sync_folder(folder)
        if step.new is None:
            _remove(folder / step.name)
        elif os.path.exists(new := os.path.join(room, step.new)):
            os.replace(new, os.path.join(folder, step.name))
    sync_folder(folder)


def _undo(folder: Path, room: Path, steps: list[_FileStep], marker: str | None) -> None:
    if steps and steps[-1].name == marker and steps[-1].new and not (room / steps[-1].new).exists():
        _remove(folder / steps[-1].name)
    for step in steps:
        if step.old is not None and os.path.lexists(room / step.old):
            os.replace(room / step.old, folder / step.name)
        elif step.old is None and step.new is not None and not (room / step.new).exists():
            _remove(folder / step.name)
    sync_folder(folder)


def _remove(path: Path) -> None:
    with contextlib.suppress(FileNotFoundError):
        path.unlink()


def _place(path: str, content: bytes | Path) -> None:
    if isinstance(content, Path):
        shutil.move(content, path)
    else:
        write(path, content)


def write(path: str | Path, content: bytes) -> None:
    """A file that is not there yet."""
    handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), 0o666)
    try:
        rest = memoryview(content)
        while rest:
            rest = rest[os.write(handle, rest) :]
    finally:
        os.close(handle)


def sync_of_many(paths: Sequence[Path]) -> None:
    """Make contents outlast a loss of power. Raises `OSError` for what could not be written.

    Of many files each alone takes a commit of the file system, milliseconds. Linux writes
    everything at once and waits for it, but before 5.12 only for a file does it tell of errors.
    """
    if sys.platform == "linux" and len(paths) > _MANY:
        if _is_synced(paths[0].parent):
            return
        os.sync()
    for path in paths:
        _sync(path)


def _is_synced(folder: Path) -> bool:
    """Whether all that was written to the file system of a folder is safe now, and the system
    would have told otherwise. Raises `OSError` for what could not be written."""
    call = _syncfs()
    if call is None:
        return False
    handle = os.open(folder, os.O_RDONLY)
    try:
        if call(handle) != 0:
            number = ctypes.get_errno()
            raise OSError(number, os.strerror(number), str(folder))
    finally:
        os.close(handle)
    return True


@cache
def _syncfs() -> Callable[[int], int] | None:
    """The call of Linux for a whole file system, where it tells of errors."""
    version = tuple(map(int, re.findall(r"\d+", os.uname().release)[:2]))
    library = ctypes.CDLL(None, use_errno=True)
    return getattr(library, "syncfs", None) if version >= _TELLS_OF_ERRORS else None


def _sync(path: Path) -> None:
    handle = os.open(path, os.O_RDWR if os.name == "nt" else os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def sync_folder(folder: Path) -> None:
    """Make renames in a folder outlast a loss of power, where the system can do that."""
    with contextlib.suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def _as_json(steps: list[_FileStep], marker: str | None) -> bytes:
    return json.dumps({"marker": marker, "steps": [asdict(step) for step in steps]}).encode()


def _from_json(content: bytes) -> tuple[list[_FileStep], str | None]:
    """The steps of a journal. Raises `OSError` for one that names files outside its folder."""
    try:
        record = json.loads(content)
        steps, marker = [_FileStep(**step) for step in record["steps"]], record["marker"]
        names = [name for step in steps for name in (step.name, step.new, step.old) if name]
        if all(map(is_plain, names)):
            return steps, marker
    except (ValueError, KeyError, TypeError):
        pass
    raise OSError(errno.EINVAL, f"a folder `{PREFIX}*` in it has no journal that can be read")
