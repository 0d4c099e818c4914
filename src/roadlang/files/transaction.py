"""Several files of a folder replaced together, so that a kill at any moment can be made good.

New contents and the files that they replace are gathered in a separate folder, `.roadlang-*`,
beside the files. Its journal is what decides: before there is one, nothing has happened;
`journal.json` says that the new files are to be put in place, `undo.json` that the old ones are.
Either is carried out from the beginning as often as it takes. New files that were staged in the
folder are not gathered: the journal names where they are, and they are moved once.
"""

from __future__ import annotations

import contextlib
import errno
import json
import os
import shutil
import tempfile
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from .locking import may_be_held
from .reading import UnreadableFile, refuse_others
from .syncing import sync_folder, sync_of_many

PREFIX = ".roadlang-"
STAGED = f"{PREFIX}new-"
"""Begins the names of folders in which files are gathered under a lock; the names of those of
transactions have no second hyphen."""
_JOURNAL, _UNDO = "journal.json", "undo.json"


@dataclass(frozen=True)
class _FileStep:
    """A file of the folder, and what stands for it in the transaction's own folder."""

    name: str
    new: str | None
    """None: the file is removed. `STAGING_FOLDER/NAME`: it is taken from there"""
    old: str | None
    """None: the file was not there"""

    def place(self, folder: Path, room: Path) -> str:
        """Where the new file is until it is put in place."""
        assert self.new is not None
        return os.path.join(folder if "/" in self.new else room, self.new)

    @property
    def names_own_files(self) -> bool:
        """Whether all its files are of the folder, the transaction's own or a staging folder."""
        staging, slash, new = (self.new or "").rpartition("/")
        is_staging = staging.startswith(STAGED) and is_plain(staging) and is_plain(new)
        names = [name for name in (self.name, new, self.old) if name]
        return (is_staging or not slash) and all(map(is_plain, names))


def replace_files(
    folder: Path,
    contents: Mapping[str, bytes | os.PathLike[str]],
    removed: Iterable[str],
    marker: str | None,
) -> None:
    """Write `contents` by name and remove `removed`, all or nothing. Of a path the file is moved;
    one in a staging folder of `folder` only when all is ready: until then it stays there.

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
    found = sorted(name for name in os.listdir(folder) if name.startswith(PREFIX))
    # Transactions first: their journals may name files that are still in staging folders.
    for name in sorted(found, key=_is_staging):
        room = folder / name
        if _is_staging(name) and may_be_held(room):
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


def is_awaited(staging: Path) -> bool:
    """Whether the journal of an unfinished transaction names files of a staging folder."""
    folder = staging.parent
    for name in os.listdir(folder):
        if name.startswith(PREFIX) and not _is_staging(name):
            for journal in (_UNDO, _JOURNAL):
                with contextlib.suppress(OSError):
                    steps, _ = _from_json((folder / name / journal).read_bytes())
                    if any(step.new and step.new.startswith(f"{staging.name}/") for step in steps):
                        return True
    return False


def _is_staging(name: str) -> bool:
    return name.startswith(STAGED)


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
    contents: Mapping[str, bytes | os.PathLike[str]],
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
        new = None
        if name in contents:
            new = _staged(folder, contents[name]) or _placed(room, f"new-{number}", contents[name])
        steps.append(_FileStep(name, new, _backup(folder, name, room, number)))
    sync_of_many([step.place(folder, room) for step in steps if step.new is not None])
    for staging in {step.new.partition("/")[0] for step in steps if step.new and "/" in step.new}:
        sync_folder(folder / staging)
    return steps


def _staged(folder: Path, content: bytes | os.PathLike[str]) -> str | None:
    """`STAGING_FOLDER/NAME` of a file in a staging folder of `folder`."""
    if isinstance(content, bytes):
        return None
    path, start = os.fspath(content), os.path.join(folder, "")
    if not path.startswith(start + STAGED):
        return None
    name = path[len(start) :].replace(os.sep, "/")
    return name if name.count("/") == 1 else None


def _placed(room: Path, name: str, content: bytes | os.PathLike[str]) -> str:
    """The name of a new file in the transaction's own folder."""
    if isinstance(content, bytes):
        write(os.path.join(room, name), content)
    else:
        shutil.move(os.fspath(content), room / name)
    return name


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
    if last is not None and last.name == marker and _waits(last, folder, room):
        _remove(folder / marker)
        sync_folder(folder)
    for step in steps:
        if step is last:
            sync_folder(folder)
        if step.new is None:
            _remove(folder / step.name)
        elif os.path.exists(new := step.place(folder, room)):
            os.replace(new, os.path.join(folder, step.name))
    sync_folder(folder)


def _undo(folder: Path, room: Path, steps: list[_FileStep], marker: str | None) -> None:
    last = steps[-1] if steps else None
    if last and last.name == marker and last.new and not _waits(last, folder, room):
        is_undone = last.old is not None and not os.path.lexists(room / last.old)
        if not is_undone:
            _remove(folder / last.name)
    for step in steps:
        if step.old is not None and os.path.lexists(room / step.old):
            os.replace(room / step.old, folder / step.name)
        elif step.old is None and step.new and not _waits(step, folder, room):
            _remove(folder / step.name)
    sync_folder(folder)


def _waits(step: _FileStep, folder: Path, room: Path) -> bool:
    """Whether there is a new file that is not in place yet."""
    return step.new is not None and os.path.exists(step.place(folder, room))


def _remove(path: Path) -> None:
    with contextlib.suppress(FileNotFoundError):
        path.unlink()


def write(path: str | Path, content: bytes) -> None:
    """A file that is not there yet."""
    handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), 0o666)
    try:
        rest = memoryview(content)
        while rest:
            rest = rest[os.write(handle, rest) :]
    finally:
        os.close(handle)


def _as_json(steps: list[_FileStep], marker: str | None) -> bytes:
    return json.dumps({"marker": marker, "steps": [vars(step) for step in steps]}).encode()


def _from_json(content: bytes) -> tuple[list[_FileStep], str | None]:
    """The steps of a journal. Raises `OSError` for one that names files outside its folder."""
    try:
        record = json.loads(content)
        steps, marker = [_FileStep(**step) for step in record["steps"]], record["marker"]
        if all(step.names_own_files for step in steps):
            return steps, marker
    except (ValueError, KeyError, TypeError):
        pass
    raise OSError(errno.EINVAL, f"a folder `{PREFIX}*` in it has no journal that can be read")
