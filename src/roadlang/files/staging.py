"""Sets of files that are written one by one, as they are found, and appear all at once.

They are gathered in a folder of their own: beside the one that they are for, which it becomes by
one renaming; where that folder is there already, inside it. Whoever gathers holds a lock on that
folder: one that nobody holds was left by a process that died, and is removed. Where folders cannot
be locked, what such a process left stays.
"""

from __future__ import annotations

import contextlib
import itertools
import os
import shutil
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from .locking import folder_lock, held_lock, may_be_held
from .syncing import sync_folder, sync_of_many
from .transaction import STAGED, is_awaited, is_plain, recover, remove_tree, replace_files
from .transaction import write as write_new
from .writing import created, reason_of, reported

Belonging = Callable[[Path], Iterable[str]]
_SIDE = ".side"
"""The folder in a room that other processes write in: no name of a backend begins with a dot."""
_numbers = itertools.count()
"""Of the files that this process has written there."""


class StagedFile(NamedTuple):
    """The path of a staged content: there are many, and this is sent in less time than a `Path`."""

    path: str

    def __fspath__(self) -> str:
        return self.path


@dataclass(frozen=True)
class StagingFolder:
    """Where other processes of this machine write what is to become files of `folder`. What is not
    added in the end, as that of a process that was lost, is removed with the room."""

    folder: Path
    path: Path

    def stage(self, content: bytes) -> StagedFile:
        """Write a content under a name that nobody else has. Raises `DiagnosticError` RL460."""
        start = f"{os.path.join(self.path, str(os.getpid()))}-"
        while True:
            place = start + str(next(_numbers))
            try:
                write_new(place, content)
            except FileExistsError:
                continue  # a process that was lost may have had the same number
            except OSError as error:
                raise reason_of(self.folder, error) from error
            return StagedFile(place)


class StagedFiles:
    """The files that were added so far, of what is to be `folder`."""

    def __init__(self, folder: Path, room: Path) -> None:
        self._folder = folder
        self._room = room
        self._names: list[str] = []

    def staging_folder(self) -> StagingFolder:
        """For other processes. Raises `DiagnosticError` RL460."""
        side = self._room / _SIDE
        with reported(self._folder):
            side.mkdir(exist_ok=True)
        return StagingFolder(self._folder, side)

    def add(self, name: str, content: bytes | os.PathLike[str]) -> None:
        """Write a file of another name than those before, or move it from a staging folder.
        Raises `DiagnosticError` RL460."""
        if not is_plain(name):
            raise ValueError(f"`{name}` is not the name of a file in a folder")
        with reported(self._folder):
            place = os.path.join(self._room, name)
            if isinstance(content, bytes):
                write_new(place, content)
            else:
                os.rename(content, place)
        self._names.append(name)

    def paths(self) -> dict[str, Path]:
        """Where they are, by name."""
        return {name: self._room / name for name in self._names}

    def close_staging_folder(self) -> None:
        """Remove it, with what was not added."""
        if (self._room / _SIDE).exists():
            shutil.rmtree(self._room / _SIDE)


@contextlib.contextmanager
def staged_set(folder: Path, marker: str, belonging: Belonging) -> Iterator[StagedFiles]:
    """What is added inside is in `folder` afterwards; nothing of it is where an error leaves it.

    `marker` and `belonging` are those of `write_set`. Raises `DiagnosticError` RL460.
    """
    base = folder if os.path.lexists(folder) else folder.parent
    with contextlib.ExitStack() as stack:
        with reported(folder):
            stack.enter_context(created(base))
            room = stack.enter_context(_held_room(base))
        files = StagedFiles(folder, room)
        yield files
        with reported(folder):
            files.close_staging_folder()
            if base is folder or not _became(folder, room, files):
                _move(folder, files, marker, belonging)


@contextlib.contextmanager
def staging_folder(folder: Path) -> Iterator[StagingFolder]:
    """In an existing folder, for work whose files are added part by part. Raises `DiagnosticError`
    RL460."""
    with contextlib.ExitStack() as stack:
        with reported(folder):
            room = stack.enter_context(_held_room(folder))
        yield StagingFolder(folder, room)


@contextlib.contextmanager
def _held_room(base: Path) -> Iterator[Path]:
    """A new folder in another, with its lock; at the end it is removed where it still is there."""
    with contextlib.ExitStack() as stack:
        with folder_lock(base):
            if _left(base):
                recover(base)
            room = _new_room(base)
            stack.callback(_remove_unless_awaited, room)
            stack.enter_context(held_lock(room))
        yield room


def _new_room(base: Path) -> Path:
    """Not by `tempfile`, whose folders nobody else may read."""
    number = 0
    while True:
        room = base / f"{STAGED}{os.getpid()}-{number}"
        try:
            room.mkdir()
        except FileExistsError:
            number += 1
        else:
            return room


def _became(folder: Path, room: Path, files: StagedFiles) -> bool:
    """Whether the room is the folder now; not where there is such a folder since."""
    sync_of_many(list(files.paths().values()))
    sync_folder(room)
    with folder_lock(folder.parent):
        if os.path.lexists(folder):
            return False
        os.rename(room, folder)
        sync_folder(folder.parent)
    return True


def _move(folder: Path, files: StagedFiles, marker: str, belonging: Belonging) -> None:
    with folder_lock(folder):
        recover(folder)
        earlier = folder / marker
        removed = belonging(earlier) if os.path.lexists(earlier) else ()
        replace_files(folder, files.paths(), removed, marker)


def _left(base: Path) -> bool:
    """Whether processes that were killed left staging folders. The caller holds the lock."""
    found = (base / name for name in os.listdir(base) if name.startswith(STAGED))
    return any(not may_be_held(room) for room in found)


def _remove_unless_awaited(room: Path) -> None:
    """What could neither be put in place nor undone is finished by whoever writes there next."""
    with contextlib.suppress(FileNotFoundError):
        if not is_awaited(room):
            remove_tree(room)
