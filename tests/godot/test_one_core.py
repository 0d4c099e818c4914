"""An engine and its client are on one core while they take turns, and free again afterwards."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
from collections.abc import Iterator

import pytest

from roadlang_godot.one_core import on_one_core

pytestmark = pytest.mark.skipif(
    not hasattr(os, "sched_setaffinity"), reason="the system does not keep threads on cores"
)


@pytest.fixture
def process() -> Iterator[subprocess.Popen[bytes]]:
    """Another process, which waits."""
    wait = [sys.executable, "-c", "input()"]
    with subprocess.Popen(wait, stdin=subprocess.PIPE, stderr=subprocess.DEVNULL) as running:
        yield running
        running.kill()


def test_both_are_on_one_core_and_then_on_any(process: subprocess.Popen[bytes]) -> None:
    allowed = os.sched_getaffinity(0)
    with contextlib.suppress(KeyError), on_one_core(process.pid):
        (core,) = os.sched_getaffinity(0)
        assert core in allowed
        assert os.sched_getaffinity(process.pid) == {core}
        raise KeyError
    assert os.sched_getaffinity(0) == allowed
    assert os.sched_getaffinity(process.pid) == allowed


def test_the_client_is_free_again_where_the_process_has_ended(
    process: subprocess.Popen[bytes],
) -> None:
    allowed = os.sched_getaffinity(0)
    with on_one_core(process.pid):
        process.kill()
        process.wait()
    assert os.sched_getaffinity(0) == allowed
    with on_one_core(None):
        assert os.sched_getaffinity(0) == allowed
