"""Whether worker processes are forked, and what that is worth."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="processes are forked on Linux")

ALONE = """
import socket, threading
from roadlang.search.start_method import start_method
print(start_method())
is_over = threading.Event()
thread = threading.Thread(target=is_over.wait)
thread.start()
print(start_method())
is_over.set()
thread.join()
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
