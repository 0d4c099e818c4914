"""Worker processes: results in order, and no process left behind."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from multiprocessing import util
from pathlib import Path
from typing import Any

import pytest

from roadlang.plugins.termination import end_on_sigterm
from roadlang.search.worker_pool import WorkerPool, Workers


def shifted(state: int, job: int) -> tuple[int, int]:
    """The job plus the state, and the process that did it."""
    return state + job, os.getpid()


def endless(folder: Path, job: str) -> str:
    """`first` ends once `second` has begun, which goes on for long and leaves a file at its end."""
    if job == "first":
        while not (folder / "begun").exists():
            time.sleep(0.01)
        return job
    (folder / "begun").touch()
    time.sleep(60.0)
    (folder / "ended").touch()
    return job


@pytest.fixture
def others() -> set[int | None]:
    """The processes that were there before."""
    return {process.pid for process in multiprocessing.active_children()}


def left_behind(others: set[int | None]) -> set[int | None]:
    return {process.pid for process in multiprocessing.active_children()} - others


def test_processes_give_results_in_order_and_end_with_the_pool(others: set[int | None]) -> None:
    with WorkerPool(100, Workers(2)) as pool:
        found = list(pool.map(shifted, range(6)))
        assert [value for value, _ in found] == [100, 101, 102, 103, 104, 105]
        assert os.getpid() not in {process for _, process in found}
        assert left_behind(others)
        again = list(pool.map(shifted, [7, 8]))  # by the same processes
        assert {process for _, process in again} <= left_behind(others)
    assert left_behind(others) == set()


def test_processes_end_where_the_work_fails(others: set[int | None]) -> None:
    def fail() -> None:
        with WorkerPool(100, Workers(2)) as pool:
            list(pool.map(shifted, [1, 2]))
            raise KeyError

    with pytest.raises(KeyError):
        fail()
    assert left_behind(others) == set()


def test_nobody_waits_for_what_is_worked_on_where_the_work_fails(
    tmp_path: Path, others: set[int | None]
) -> None:
    def fail() -> None:
        with WorkerPool(tmp_path, Workers(2)) as pool:
            for result in pool.map(endless, ["first", "second"]):
                raise KeyError(result)

    with pytest.raises(KeyError, match="first"):
        fail()
    assert left_behind(others) == set()
    assert not (tmp_path / "ended").exists()


@pytest.mark.parametrize(("jobs", "fewest"), [([3], 2), ([1, 2, 3], 4)])
def test_a_few_jobs_are_done_in_this_process(
    jobs: list[int], fewest: int, others: set[int | None]
) -> None:
    with WorkerPool(100, Workers(2)) as pool:
        found = list(pool.map(shifted, jobs, fewest))
    assert found == [(100 + job, os.getpid()) for job in jobs]
    assert left_behind(others) == set()


def length(state: bytes, job: int) -> int:
    return len(state) + job


@pytest.fixture
def other_thread() -> Iterator[None]:
    """A thread beside the one that tests: then processes are not forked."""
    is_over = threading.Event()
    thread = threading.Thread(target=is_over.wait)
    thread.start()
    yield
    is_over.set()
    thread.join()


@pytest.mark.usefixtures("other_thread")
@pytest.mark.skipif(os.name == "nt", reason="processes are started in POSIX's way")
def test_a_process_killed_before_it_read_what_is_shared_is_replaced(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """What is shared is more than a pipe holds: nobody waits for it to be read."""
    start, died = util.spawnv_passfds, list[int]()

    def first_dies(program: Any, words: Any, files: Any) -> int:
        is_first = not died and any("spawn_main" in str(word) for word in words)
        process: int = start(program, [words[0], "-c", ""] if is_first else words, files)
        if is_first:
            died.append(process)
        return process

    monkeypatch.setattr(util, "spawnv_passfds", first_dies)
    with WorkerPool(bytes(1_000_000), Workers(2)) as pool:
        assert list(pool.map(length, [1, 2, 3])) == [1_000_001, 1_000_002, 1_000_003]
    assert died


class KillingOnce:
    """A state that kills the first process that reads it."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def __reduce__(self) -> tuple[Callable[[Path], KillingOnce], tuple[Path]]:
        return _read_or_killed, (self.folder,)


def _read_or_killed(folder: Path) -> KillingOnce:
    try:
        (folder / "read").touch(exist_ok=False)
    except FileExistsError:
        return KillingOnce(folder)
    os.kill(os.getpid(), signal.SIGTERM)  # which a process hears from its start on
    pytest.fail("it goes on")


def doubled(state: KillingOnce, job: int) -> int:
    return 2 * job


@pytest.mark.skipif(os.name == "nt", reason="SIGTERM is POSIX's")
def test_a_forked_process_killed_before_it_read_what_is_shared_is_replaced(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    before = signal.getsignal(signal.SIGTERM)
    end_on_sigterm()  # as the command line does: a copy of it would report the end as an error
    try:
        with WorkerPool(KillingOnce(tmp_path), Workers(2)) as pool:
            assert list(pool.map(doubled, [1, 2, 3])) == [2, 4, 6]
    finally:
        signal.signal(signal.SIGTERM, before)
    assert (tmp_path / "read").exists()
    assert capfd.readouterr().err == ""


def test_one_process_works_here() -> None:
    with WorkerPool(100, Workers(1)) as pool:
        assert list(pool.map(shifted, [1, 2, 3])) == [(100 + n, os.getpid()) for n in (1, 2, 3)]
        assert pool.workers == 1


def reported(folder: Path, job: str) -> None:
    """Leaves the number of its process, and works for long."""
    (folder / f"{job}.begun").write_text(str(os.getpid()))
    (folder / f"{job}.begun").rename(folder / f"{job}.pid")
    time.sleep(600.0)


@pytest.mark.skipif(os.name == "nt", reason="processes are looked up in POSIX's way")
def test_processes_end_with_a_parent_that_is_killed(tmp_path: Path) -> None:
    program = (
        "import sys\n"
        "from pathlib import Path\n"
        "from roadlang.search.worker_pool import WorkerPool, Workers\n"
        "from tests.search.test_worker_pool import reported\n"
        "if __name__ == '__main__':\n"
        "    with WorkerPool(Path(sys.argv[1]), Workers(2)) as pool:\n"
        "        list(pool.map(reported, ['first', 'second']))\n"
    )
    (tmp_path / "program.py").write_text(program)
    root = Path(__file__).parents[2]
    parent = subprocess.Popen(
        [sys.executable, str(tmp_path / "program.py"), str(tmp_path)],
        cwd=root,
        env={**os.environ, "PYTHONPATH": str(root)},
    )
    files = [tmp_path / "first.pid", tmp_path / "second.pid"]
    _wait_until(lambda: all(file.exists() for file in files))
    parent.kill()
    parent.wait()
    workers = [int(file.read_text()) for file in files]
    _wait_until(lambda: not any(map(_runs, workers)))


def _wait_until(holds: Callable[[], bool]) -> None:
    """Only a hang fails."""
    for _ in range(6000):
        if holds():
            return
        time.sleep(0.02)
    pytest.fail("it does not happen")


def _runs(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    # Whoever adopts what is left behind may be slow to reap it.
    state = subprocess.run(
        ["ps", "-o", "stat=", "-p", str(process)], capture_output=True, text=True, check=False
    ).stdout
    return bool(state.strip()) and not state.startswith("Z")


class Interrupting:
    """A state whose copy in a worker is made while Ctrl-C arrives, before the first job."""

    def __reduce__(self) -> tuple[Callable[[], str], tuple[()]]:
        return _interrupted_copy, ()


def _interrupted_copy() -> str:
    os.kill(os.getpid(), signal.SIGINT)
    return "copied"


def interrupted(state: Any, job: int) -> tuple[Any, int]:
    """Ctrl-C arrives again during the job, and in a program that is started for it."""
    os.kill(os.getpid(), signal.SIGINT)
    program = [sys.executable, "-c", "import os, signal; os.kill(os.getpid(), signal.SIGINT)"]
    return state, subprocess.run(program, stderr=subprocess.DEVNULL).returncode


@pytest.mark.parametrize("is_forked", [True, False])
def test_interruptions_are_for_whoever_hands_out_the_work(
    is_forked: bool, request: pytest.FixtureRequest
) -> None:
    if not is_forked:
        request.getfixturevalue("other_thread")
    with WorkerPool(Interrupting(), Workers(2)) as pool:
        found = list(pool.map(interrupted, range(8)))
    assert found == [("copied", -signal.SIGINT)] * 8
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    assert signal.SIGINT not in signal.pthread_sigmask(signal.SIG_BLOCK, ())
