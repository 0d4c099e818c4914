"""What a job leaves behind is gone before the next begins, however rarely memory is collected."""

from __future__ import annotations

import gc
from collections.abc import Iterator

import pytest

from roadlang.search.worker_pool import WorkerPool, Workers


class Batch:
    """Refers to itself, as candidates and their roads do."""

    alive = 0

    def __init__(self) -> None:
        self.itself = self
        Batch.alive += 1

    def __del__(self) -> None:
        Batch.alive -= 1


def before(state: None, job: int) -> int:
    """How many were left by the jobs before."""
    found = Batch.alive
    Batch()
    return found


@pytest.fixture
def rarely_collected() -> Iterator[None]:
    thresholds = gc.get_threshold()
    gc.set_threshold(400_000, 20, 100)
    yield
    gc.set_threshold(*thresholds)


@pytest.mark.usefixtures("rarely_collected")
@pytest.mark.parametrize("jobs", [1, 2])
def test_nothing_is_left_by_the_jobs_before(jobs: int) -> None:
    with WorkerPool(None, Workers(jobs)) as pool:
        assert [*pool.map(before, range(6))] == [0] * 6
