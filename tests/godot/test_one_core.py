"""An engine and its client are on one core while they take turns, no other such pair is there, and
both are free again afterwards."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator

import pytest

from roadlang_godot.engines import one_core
from roadlang_godot.engines.one_core import on_one_core

pytestmark = pytest.mark.skipif(
    not hasattr(os, "sched_setaffinity"), reason="the system does not keep threads on cores"
)
Waiting = subprocess.Popen[bytes]


@pytest.fixture(autouse=True)
def own_names(monkeypatch: pytest.MonkeyPatch) -> str:
    """Engines of others on this machine have no say."""
    name = f"\0roadlang/test/{os.getpid()}/"
    monkeypatch.setattr(one_core, "_RESERVED", name)
    return name


@pytest.fixture
def start() -> Iterator[Callable[[], Waiting]]:
    """Starts other processes, which wait."""
    with contextlib.ExitStack() as ends:

        def started() -> Waiting:
            wait = [sys.executable, "-c", "input()"]
            process = subprocess.Popen(wait, stdin=subprocess.PIPE, stderr=subprocess.DEVNULL)
            ends.enter_context(process)
            ends.callback(process.kill)
            return process

        yield started


@pytest.fixture
def few_cores() -> Iterator[list[int]]:
    """Two cores at most are allowed, as in a container."""
    allowed = os.sched_getaffinity(0)
    os.sched_setaffinity(0, sorted(allowed)[-2:])
    yield sorted(allowed)[-2:]
    os.sched_setaffinity(0, allowed)


def test_both_are_on_one_core_and_then_on_any(start: Callable[[], Waiting]) -> None:
    allowed, process = os.sched_getaffinity(0), start()
    with contextlib.suppress(KeyError), on_one_core(process.pid):
        (core,) = os.sched_getaffinity(0)
        assert core in allowed
        assert os.sched_getaffinity(process.pid) == {core}
        raise KeyError
    assert os.sched_getaffinity(0) == allowed
    assert os.sched_getaffinity(process.pid) == allowed


def test_the_client_is_free_again_where_the_process_has_ended(
    start: Callable[[], Waiting],
) -> None:
    allowed, process = os.sched_getaffinity(0), start()
    with on_one_core(process.pid):
        process.kill()
        process.wait()
    assert os.sched_getaffinity(0) == allowed
    for gone in (None, process.pid):
        with on_one_core(gone):
            assert os.sched_getaffinity(0) == allowed


def test_no_two_pairs_are_on_the_same_core(
    start: Callable[[], Waiting], few_cores: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    # All begin on the same core, as threads do that wake one another.
    monkeypatch.setattr(one_core, "_core_here", lambda: few_cores[-1])
    places: dict[int, set[int]] = {}
    begun, done = threading.Semaphore(0), threading.Event()

    def pair(number: int, process: int) -> None:
        with on_one_core(process):
            places[number] = os.sched_getaffinity(process)
            assert os.sched_getaffinity(0) == places[number]
            begun.release()
            done.wait()

    threads = []
    for number in range(len(few_cores) + 1):
        threads.append(threading.Thread(target=pair, args=(number, start().pid)))
        threads[-1].start()
        begun.acquire()
    done.set()
    for thread in threads:
        thread.join()
    assert [places[number] for number in range(len(few_cores))] == [
        {core} for core in reversed(few_cores)
    ]
    assert places[len(few_cores)] == set(few_cores)
    with on_one_core(start().pid):
        assert os.sched_getaffinity(0) == {few_cores[-1]}


def test_a_process_stays_on_the_cores_that_it_may_use(
    start: Callable[[], Waiting], few_cores: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(one_core, "_core_here", lambda: few_cores[-1])
    process = start()
    os.sched_setaffinity(process.pid, few_cores[:1])
    with on_one_core(process.pid):
        assert os.sched_getaffinity(0) == set(few_cores[:1])
    assert os.sched_getaffinity(0) == set(few_cores)
    assert os.sched_getaffinity(process.pid) == set(few_cores[:1])


def test_the_core_of_who_was_killed_is_free(
    start: Callable[[], Waiting], few_cores: list[int], own_names: str
) -> None:
    hold = f"""
import socket
place = [socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) for _ in range({len(few_cores)})]
for one, core in zip(place, {few_cores}):
    one.bind({own_names!r} + str(core))
print("held", flush=True)
input()
"""
    command = [sys.executable, "-c", hold]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as other:
        assert other.stdout is not None
        assert other.stdout.readline() == b"held\n"
        with on_one_core(start().pid):
            assert os.sched_getaffinity(0) == set(few_cores)
        other.kill()
        other.wait()
    with on_one_core(start().pid):
        assert len(os.sched_getaffinity(0)) == 1
