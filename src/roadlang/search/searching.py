"""The search for accepted candidates: a stream for each scene, or one stream for all."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from .accepted import AcceptedSamples, Sample
from .rejection_report import RejectionStats
from .samplers import Progress
from .scene_search import SceneSearch
from .streams import accepted_of_stream
from .worker_pool import ALONE, WorkerPool, Workers

BLOCKS = ((64, 16), (256, 64))
"""Up to how many scenes how many of them are searched for together: a batch of candidates costs as
much as hundreds of them. No scene depends on it."""
LARGEST_BLOCK, SENT_BLOCK = 256, 128
"""Of more scenes; of those that are sent with the contents of their files, which are large."""
_FEWEST_FOR_PROCESSES = 8
_PARTS = 4
"""Parts of the work for each worker: few, for each costs a message, but all should end together."""
_MOST_BLOCKS, _MOST_SAMPLES, _MOST_SCENES = 4, 64, 128
"""The most blocks, samples and scenes in a part, so that a lost worker loses little, and scenes
that wait to be written do not fill the memory."""
T = TypeVar("T")
J = TypeVar("J")


def search(
    task: SceneSearch[T],
    n: int | None,
    workers: Workers = ALONE,
    keep: Callable[[Sample[T]], Sample[Any]] | None = None,
    sent: int = LARGEST_BLOCK,
) -> AcceptedSamples[Any]:
    """The first `n` scenes by the scenario's sampler. `keep` says what is kept of each; it is
    called with one after the other, in their order, as soon as they are there. `sent`: the most
    scenes that another process hands back together."""
    with WorkerPool(task, workers) as pool:
        if task.sampler.kind.sequential:
            return _search_stream(task, n, pool, workers.progress, keep)
        return _search_scenes(task, n or 1, pool, workers.progress, keep, sent)


def _search_scenes(
    task: SceneSearch[T],
    n: int,
    pool: WorkerPool[SceneSearch[T]],
    progress: Progress | None,
    keep: Callable[[Sample[T]], Sample[Any]] | None,
    sent: int,
) -> AcceptedSamples[Any]:
    """Scene 0 first and alone: if it is given up, so is everything."""
    found = AcceptedSamples[Any](n, RejectionStats.empty(len(task.acceptance.requirements)))
    blocks = [range(1)]
    size = next((size for most, size in BLOCKS if n <= most), LARGEST_BLOCK)
    size = min(size, sent) if pool.workers > 1 else size
    blocks += _even_blocks(1, n, size, pool.workers)
    for part in (blocks[:1], blocks[1:]):
        most = max(1, min(_MOST_BLOCKS, _MOST_SCENES // size))
        shares = _shares(part, pool.workers, most)
        for searched in pool.map(SceneSearch.search_blocks, shares):
            for block in searched:
                found.samples.extend(block.samples if keep is None else map(keep, block.samples))
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
    keep: Callable[[Sample[T]], Sample[Any]] | None,
) -> AcceptedSamples[Any]:
    stream = accepted_of_stream(task.acceptance, task.sampler, task.seed, n)
    found = AcceptedSamples[Any](stream.wanted, stream.stats, missing=list(stream.missing))
    workers = pool.workers if len(stream.accepted) >= _FEWEST_FOR_PROCESSES else 1
    shares = _shares(stream.accepted, workers, _MOST_SAMPLES, alone=_MOST_SAMPLES)
    for samples in pool.map(SceneSearch.samples, shares):
        found.samples.extend(samples if keep is None else map(keep, samples))
        if progress is not None:
            progress(len(found.samples), len(stream.accepted))
    return found


def _even_blocks(start: int, stop: int, size: int, workers: int) -> list[range]:
    """Blocks of about `size` scenes, as many for each worker unless they were then less than half
    as large: a few scenes that are left over would cost as much as a block."""
    count = max(1, round((stop - start) / size)) if stop > start else 0
    for_all = -(-count // workers) * workers
    count = for_all if for_all <= 2 * count else count
    ends = [start + (stop - start) * part // count for part in range(1, count + 1)]
    return [range(*pair) for pair in zip([start, *ends], ends, strict=False)]


def _shares(jobs: Sequence[J], workers: int, most: int, alone: int = 1) -> list[Sequence[J]]:
    """Jobs in parts that are worth a message each; without workers in parts of `alone`, to see how
    it goes."""
    size = alone if workers == 1 else max(1, min(most, -(-len(jobs) // (_PARTS * workers))))
    return [jobs[start : start + size] for start in range(0, len(jobs), size)]
