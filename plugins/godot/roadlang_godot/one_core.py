"""Keeps an engine and its client on one core while they take turns: what wakes up on another core
finds cold caches there, and waking it costs more than many a step."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

_CORE = 36
"""field of /proc/.../stat after the name: where a thread runs"""


@contextlib.contextmanager
def on_one_core(process: int | None) -> Iterator[None]:
    """This thread and all threads of a process stay on the core where this thread runs now.

    Where the process is None, or the system has no such wish, nothing happens.
    """
    core = None if process is None else _core_here()
    if process is None or core is None:
        yield
        return
    allowed = os.sched_getaffinity(0)
    _keep(process, {core})
    try:
        yield
    finally:
        _keep(process, allowed)


def _core_here() -> int | None:
    if not hasattr(os, "sched_setaffinity"):
        return None
    try:
        text = Path("/proc/thread-self/stat").read_text(encoding="ascii", errors="replace")
        return int(text.rpartition(")")[2].split()[_CORE])
    except (OSError, ValueError, IndexError):
        return None


def _keep(process: int, cores: set[int]) -> None:
    """The process may be gone, or belong to someone else."""
    with contextlib.suppress(OSError):
        os.sched_setaffinity(0, cores)
        for thread in Path(f"/proc/{process}/task").iterdir():
            os.sched_setaffinity(int(thread.name), cores)
