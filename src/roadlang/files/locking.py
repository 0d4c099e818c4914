"""One writer at a time in a folder."""

from __future__ import annotations

import contextlib
import os
import sys
import weakref
from collections.abc import Iterator
from pathlib import Path
from typing import ClassVar

_handles: set[int] = set()
"""What this process holds locks by."""


def _close(handle: int) -> None:
    _handles.discard(handle)
    os.close(handle)


def _leave_to_parent() -> None:
    """In a process that was forked: a lock is held until all copies of its handle are closed, and
    would outlive the process that took it. The number stays taken: whoever closes it means it."""
    nowhere = os.open(os.devnull, os.O_RDONLY)
    for handle in _handles:
        os.dup2(nowhere, handle, inheritable=False)
    os.close(nowhere)
    _handles.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_leave_to_parent)


@contextlib.contextmanager
def folder_lock(folder: Path) -> Iterator[None]:
    """Wait until no other process of roadlang writes in `folder`, and keep others waiting.

    The system gives the lock back when a process dies, however it dies. Where folders cannot be
    locked (Windows, some network file systems) nothing is waited for.
    """
    if sys.platform == "win32":
        yield
        return
    import fcntl

    handle = os.open(folder, os.O_RDONLY)
    _handles.add(handle)
    try:
        with contextlib.suppress(OSError):
            fcntl.flock(handle, fcntl.LOCK_EX)
        yield
    finally:
        _close(handle)


def held_lock(folder: Path) -> contextlib.ExitStack:
    """Take the lock of a folder that nobody else knows yet, until the result is closed."""
    held = contextlib.ExitStack()
    held.enter_context(folder_lock(folder))
    return held


def may_be_held(folder: Path) -> bool:
    """Whether a process that is alive may hold a lock on a folder: where folders cannot be locked,
    nobody knows."""
    if sys.platform == "win32":
        return True
    import fcntl

    try:
        handle = os.open(folder, os.O_RDONLY)
    except OSError:
        return True
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return True
    finally:
        os.close(handle)
    return False


class FileLock:
    """The lock of a file, until nothing refers to it any more; the file is made where it is not.

    Raises `BlockingIOError` where another process has it. All of one process share it; where files
    cannot be locked (Windows, some network file systems) everyone has it.
    """

    _held: ClassVar[weakref.WeakValueDictionary[tuple[int, int], FileLock]] = (
        weakref.WeakValueDictionary()
    )

    def __new__(cls, path: Path) -> FileLock:
        """The lock that this process has, or a new one."""
        handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
        state = os.fstat(handle)
        known = cls._held.get((state.st_dev, state.st_ino))
        if known is not None or sys.platform == "win32":
            os.close(handle)
        if known is not None:
            return known
        lock = super().__new__(cls)
        if sys.platform != "win32":
            _lock_at_once(handle)
            _handles.add(handle)
            weakref.finalize(lock, _close, handle)
        cls._held[state.st_dev, state.st_ino] = lock
        return lock


def _lock_at_once(handle: int) -> None:
    if sys.platform == "win32":
        return
    import fcntl

    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        os.close(handle)
        raise
    except OSError:
        return  # a file system without locks
