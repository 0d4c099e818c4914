"""Whether worker processes are forked, and what that is worth."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="processes are forked on Linux")

ALONE = """
import os, socket, threading
from roadlang.search.start_method import start_method
print(start_method())
is_over = threading.Event()
thread = threading.Thread(target=is_over.wait)
thread.start()
print(start_method())
is_over.set()
thread.join()
while len(os.listdir("/proc/self/task")) > 1:
    pass  # it is joined a moment before it is gone
print(start_method())
with socket.socket():
    print(start_method())
print(start_method())
"""
LOADED = """
import sys
from roadlang.search.worker_pool import WorkerPool, Workers
from tests.search.test_start_method import is_loaded
import colorsys
with WorkerPool(None, Workers(2)) as pool:
    print(pool.will_fork)
    print(list(pool.map(is_loaded, ["colorsys", "this"])))
    print(pool.will_fork)
print(WorkerPool(None, Workers(1)).will_fork)
"""


UNTRACKED = """
from multiprocessing import resource_tracker
from roadlang.search.worker_pool import WorkerPool, Workers
from tests.search.test_start_method import is_loaded
with WorkerPool(None, Workers(2)) as pool:
    list(pool.map(is_loaded, ["sys", "os"]))
print(resource_tracker._resource_tracker._pid)
"""


INHERITED = """
from roadlang.search.worker_pool import WorkerPool, Workers
from tests.search.test_start_method import Sent, Unsent, number_of
with WorkerPool(100, Workers(2)) as pool:
    print(list(pool.map(number_of, [Unsent(number) for number in range(9)])))
    print(list(pool.map(number_of, [Sent(number) for number in range(20, 29)])))
"""


class Unsent:
    """A job that cannot be sent to another process."""

    def __init__(self, number: int) -> None:
        self.number = number

    def __reduce__(self) -> str:
        raise TypeError("it is not sent")


@dataclass(frozen=True)
class Sent:
    """A job that is found after the processes were forked."""

    number: int


def number_of(state: int, job: Unsent | Sent) -> int:
    return state + job.number


def is_loaded(state: None, module: str) -> bool:
    return module in sys.modules


def lines_of(code: str) -> list[str]:
    root = str(Path(__file__).parents[2])
    found = subprocess.run(
        [sys.executable, "-c", code],
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "PYTHONPATH": root},
    )
    return found.stdout.splitlines()


def test_processes_are_forked_while_there_is_one_thread_and_no_connection() -> None:
    assert lines_of(ALONE) == ["fork", "spawn", "fork", "spawn", "fork"]


def test_forked_processes_have_what_is_loaded_here() -> None:
    assert lines_of(LOADED) == ["True", "[True, False]", "False", "False"]


def test_forked_processes_need_no_process_that_keeps_track_of_shared_memory() -> None:
    assert lines_of(UNTRACKED) == ["None"]


def test_only_jobs_that_come_after_processes_are_forked_are_sent() -> None:
    assert lines_of(INHERITED) == [str([*range(100, 109)]), str([*range(120, 129)])]
