"""Worker processes use freed memory again, which is quicker than to get other memory."""

from __future__ import annotations

import platform
import resource

import pytest

from roadlang.search.worker_pool import WorkerPool, Workers

BLOCKS, SIZE, ROUNDS = 5, 8_000_000, 10
PAGE = resource.getpagesize()


def faults_of_rounds(state: None, job: int) -> int:
    """How many pages the system hands out while the same amount of memory is used and freed."""
    use_and_free()
    before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
    for _ in range(ROUNDS):
        use_and_free()
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before


def use_and_free() -> None:
    blocks = [b"x" * SIZE for _ in range(BLOCKS)]
    blocks.clear()


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="set in glibc alone")
def test_memory_that_a_worker_freed_is_not_given_back() -> None:
    with WorkerPool(None, Workers(2)) as pool:
        found = list(pool.map(faults_of_rounds, [0, 1]))
    assert max(found) < BLOCKS * SIZE // PAGE
