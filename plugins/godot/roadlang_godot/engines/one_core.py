"""Keeps an engine and its client on one core while they take turns: what wakes up on another core
finds cold caches there, and waking it costs more than many a step. A core is for one pair alone."""

from __future__ import annotations

import contextlib
import os
import socket
from collections.abc import Iterator
from pathlib import Path

_CORE = 36
"""field of /proc/.../stat after the name: where a thread runs"""
_RESERVED = "\0roadlang/core/"
"""What a socket is bound to whose owner has the core of that number. It is no file (Linux:
abstract names), and ends with its owner, however that ends."""


@contextlib.contextmanager
def on_one_core(process: int | None) -> Iterator[None]:
    """This thread and all threads of a process stay on one core that both may use and no other such
    pair has: that where this thread runs now, or another.

    Where the process is None or gone, every core is taken, or the system has no such wish, nothing
    happens.
    """
    with contextlib.ExitStack() as held:
        if process is not None:
            ours, theirs = _cores_of(0), _cores_of(process)
            core = _reserve(ours & theirs, held)
            if core is not None:
                held.callback(_keep, process, ours, theirs)
                _keep(process, {core}, {core})
        yield


def _reserve(cores: set[int], held: contextlib.ExitStack) -> int | None:
    """One of these cores that nobody has; it is ours until `held` ends."""
    here = _core_here()
    if here is None:
        return None
    for core in sorted(cores, key=lambda core: (core != here, core)):
        with contextlib.suppress(OSError), contextlib.ExitStack() as bound:
            place = bound.enter_context(socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM))
            place.bind(f"{_RESERVED}{core}")
            held.push(bound.pop_all())
            return core
    return None


def _cores_of(process: int) -> set[int]:
    """Where it may run (0: this thread). Nowhere, if it is gone."""
    if not hasattr(os, "sched_getaffinity"):
        return set()
    try:
        return os.sched_getaffinity(process)
    except OSError:
        return set()


def _core_here() -> int | None:
    try:
        text = Path("/proc/thread-self/stat").read_text(encoding="ascii", errors="replace")
        return int(text.rpartition(")")[2].split()[_CORE])
    except (OSError, ValueError, IndexError):
        return None


def _keep(process: int, ours: set[int], theirs: set[int]) -> None:
    """The process may be gone, or belong to someone else."""
    with contextlib.suppress(OSError):
        os.sched_setaffinity(0, ours)
        for thread in Path(f"/proc/{process}/task").iterdir():
            os.sched_setaffinity(int(thread.name), theirs)
