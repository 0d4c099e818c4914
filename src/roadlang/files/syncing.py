"""What was written outlasts a loss of power."""

from __future__ import annotations

import contextlib
import ctypes
import os
import re
import sys
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path

_MANY = 32
_TELLS_OF_ERRORS = (5, 12)
"""The version of Linux from which on `syncfs` does, through layered file systems too."""


def sync_of_many(paths: Sequence[str | Path]) -> None:
    """Make contents outlast a loss of power. Raises `OSError` for what could not be written.

    Of many files each alone takes a commit of the file system, milliseconds. Linux writes
    everything at once and waits for it, but before 5.12 only for a file does it tell of errors.
    """
    if sys.platform == "linux" and len(paths) > _MANY:
        if _is_synced(os.path.dirname(paths[0])):
            return
        os.sync()
    for path in paths:
        _sync(path)


def _is_synced(folder: str) -> bool:
    """Whether all that was written to the file system of a folder is safe now, and the system
    would have told otherwise. Raises `OSError` for what could not be written."""
    call = _syncfs()
    if call is None:
        return False
    handle = os.open(folder, os.O_RDONLY)
    try:
        if call(handle) != 0:
            number = ctypes.get_errno()
            raise OSError(number, os.strerror(number), folder)
    finally:
        os.close(handle)
    return True


@cache
def _syncfs() -> Callable[[int], int] | None:
    """The call of Linux for a whole file system, where it tells of errors."""
    version = tuple(map(int, re.findall(r"\d+", os.uname().release)[:2]))
    library = ctypes.CDLL(None, use_errno=True)
    return getattr(library, "syncfs", None) if version >= _TELLS_OF_ERRORS else None


def _sync(path: str | Path) -> None:
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
