"""One writer at a time in a folder."""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Iterator
from pathlib import Path


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
    try:
        with contextlib.suppress(OSError):
            fcntl.flock(handle, fcntl.LOCK_EX)
        yield
    finally:
        os.close(handle)


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
