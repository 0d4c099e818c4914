"""Worker processes: results in order, and no process left behind."""

from __future__ import annotations

import multiprocessing
import os
import time
from pathlib import Path

import pytest

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
    time.sleep(10.0)
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


def test_one_process_works_here() -> None:
    with WorkerPool(100, Workers(1)) as pool:
        assert list(pool.map(shifted, [1, 2, 3])) == [(100 + n, os.getpid()) for n in (1, 2, 3)]
        assert pool.workers == 1
