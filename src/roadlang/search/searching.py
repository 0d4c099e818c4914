"""The search for accepted candidates: a stream for each scene, or one stream for all."""

from __future__ import annotations

from typing import TypeVar

from .accepted import SearchResult
from .rejection_report import RejectionStats
from .samplers import Progress
from .scene_search import SceneSearch
from .streams import accepted_of_stream
from .worker_pool import WorkerPool

BLOCK = 16
"""Scenes searched for together; the blocks are the same however many workers there are."""
_FEWEST_FOR_PROCESSES = 8
T = TypeVar("T")


def search(
    task: SceneSearch[T], n: int | None, processes: int = 1, progress: Progress | None = None
) -> SearchResult[T]:
    """The first `n` scenes by the scenario's sampler."""
    with WorkerPool(task, processes) as pool:
        if task.sampler.kind.sequential:
            return _search_stream(task, n, pool, progress)
        return _search_scenes(task, n or 1, pool, progress)


def _search_scenes(
    task: SceneSearch[T], n: int, pool: WorkerPool[SceneSearch[T]], progress: Progress | None
) -> SearchResult[T]:
    """Scene 0 first and alone: if it is given up, so is everything."""
    found = SearchResult[T](n, RejectionStats.empty(len(task.acceptance.requirements)))
    blocks = [range(1)]
    blocks += [range(start, min(start + BLOCK, n)) for start in range(1, n, BLOCK)]
    for part in (blocks[:1], blocks[1:]):
        for block in pool.map(SceneSearch.search_block, part):
            found.samples.extend(block.samples)
            found.missing.extend(block.missing)
            found.stats.add(block.stats)
            if progress is not None:
                progress(len(found.samples) + len(found.missing), n)
        if not found.samples:
            found.missing = list(range(n))
            break
    return found


def _search_stream(
    task: SceneSearch[T],
    n: int | None,
    pool: WorkerPool[SceneSearch[T]],
    progress: Progress | None,
) -> SearchResult[T]:
    stream = accepted_of_stream(task.acceptance, task.sampler, task.seed, n)
    found = SearchResult[T](stream.wanted, stream.stats, missing=list(stream.missing))
    for sample in pool.map(SceneSearch.sample, stream.accepted, _FEWEST_FOR_PROCESSES):
        found.samples.append(sample)
        if progress is not None:
            progress(len(found.samples), len(stream.accepted))
    return found
