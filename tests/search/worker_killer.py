"""Kills a worker process while others wait for its results."""

from __future__ import annotations

import multiprocessing
import os
import signal


class WorkerKiller:
    """The progress function of a search: when it is first called with processes at work that were
    started since, it kills one of them. `killed` is its number."""

    def __init__(self) -> None:
        self._before = {process.pid for process in multiprocessing.active_children()}
        self.killed: int | None = None

    def __call__(self, done: int, wanted: int) -> None:
        ours = [p.pid for p in multiprocessing.active_children() if p.pid not in self._before]
        if self.killed is None and ours and ours[0] is not None:
            self.killed = ours[0]
            os.kill(ours[0], signal.SIGKILL)
