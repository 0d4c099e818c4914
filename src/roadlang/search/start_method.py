"""How worker processes are started."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator

FORK, SPAWN = "fork", "spawn"
_TASKS, _FILES = "/proc/self/task", "/proc/self/fd"
"""Where Linux lists the threads of a process, those of libraries too, and its open files."""


def start_method() -> str:
    """Forked where this process has no other thread and no connection: what it has imported and
    compiled is there at once, which otherwise takes each worker longer than a short search.

    A fork copies the locked locks of other threads, which nobody will ever unlock: OpenCV, BLAS and
    notebooks start threads. Two copies of a connection, to a simulator or a database, would talk
    into each other. Then a worker is a new process that imports everything itself. So it is on
    Windows, which cannot fork, and on macOS, whose libraries do not bear it.
    """
    if sys.platform != "linux":
        return SPAWN
    try:
        is_alone = len(os.listdir(_TASKS)) == 1 and not any(_connections())
    except OSError:  # the system does not tell
        return SPAWN
    return FORK if is_alone else SPAWN


def _connections() -> Iterator[bool]:
    """Of each open file, whether it is a socket."""
    for name in os.listdir(_FILES):
        try:
            yield os.readlink(f"{_FILES}/{name}").startswith("socket:")
        except FileNotFoundError:  # by which they were listed
            continue
