"""Does the work in this process or in others; the result is the same."""

from __future__ import annotations

import multiprocessing
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from typing import Any

import numpy as np

from ..evaluate.building import build
from ..evaluate.candidates import CandidateBatch
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scene import Scene
from ..judging.acceptance import Judge
from ..plugins.kinds import Sampler
from ..scenes.instantiate import instantiate
from .effort import attempts_of
from .rejection_report import RejectionStats

Block = Sequence[int]
Searched = tuple[list[Scene], list[int], RejectionStats, list[Any]]


class Worker:
    """Searches and instantiates scenes of one scenario."""

    def __init__(self, scenario: IndexedScenario, seed: int, overrides: dict[str, str]) -> None:
        self.judge = Judge(scenario)
        self.seed = seed
        self.overrides = overrides

    def search(self, scenes: Block) -> Searched:
        """The scenes of a block, those given up, and the counts."""
        from .sampling import sampler_call

        scenario = self.judge.scenario
        sampler = build(sampler_call(scenario), scenario.fixed, single=True).kind
        if is_steering(sampler):
            from .guiding import guided_search

            return guided_search(self, sampler, scenes)
        from .searching import accepted_attempts

        attempts = attempts_of(sampler, self.judge)
        accepted, stats = accepted_attempts(self.judge, self.seed, scenes, attempts)
        made, points = [], []
        for scene, attempt in sorted(accepted.items()):
            candidates = self.single(scene, attempt, {})
            candidates.asked = {}
            made.append(instantiate(candidates, scene, self.overrides))
            points.append(self.coordinates(candidates))
        return made, [scene for scene in scenes if scene not in accepted], stats, points

    def single(self, scene: int, attempt: int, given: Mapping[str, Any]) -> CandidateBatch:
        """One candidate by itself."""
        scenario = self.judge.scenario
        return CandidateBatch(scenario, self.seed, np.array([scene]), np.array([attempt]), given)

    def coordinates(self, candidates: CandidateBatch) -> dict[str, float]:
        """The draws of one candidate in the unit cube, by name."""
        return {name: float(values[0]) for name, values in (candidates.asked or {}).items()}

    def instantiate(self, index: int, attempt: int, given: Mapping[str, Any]) -> Scene:
        """Scene `index`: candidate `attempt` of a stream."""
        return instantiate(self.single(0, attempt, given), index, self.overrides)


def is_steering(sampler: Any) -> bool:
    """Whether a sampler proposes candidates from what is known of others."""
    return type(sampler).steer is not Sampler.steer


class WorkerPool:
    """One worker here, or `jobs` of them in processes of their own."""

    def __init__(
        self, scenario: IndexedScenario, seed: int, jobs: int, overrides: dict[str, str]
    ) -> None:
        self._worker = Worker(scenario, seed, overrides)
        self._jobs = max(1, jobs)
        self._pool: ProcessPoolExecutor | None = None
        self._others = frozenset(multiprocessing.active_children())

    def __enter__(self) -> WorkerPool:
        return self

    def __exit__(self, kind: type[BaseException] | None, *error: object) -> None:
        if self._pool is None:
            return
        if kind is not None:  # nobody waits for what the workers are doing
            for process in set(multiprocessing.active_children()) - self._others:
                process.terminate()
        self._pool.shutdown(wait=True, cancel_futures=True)

    def search(self, blocks: Sequence[Block]) -> Iterator[Searched]:
        """The blocks in order."""
        if self._jobs == 1 or len(blocks) < 2:
            yield from (self._worker.search(block) for block in blocks)
        else:
            pool = self._started()
            yield from _in_order([pool.submit(_search, list(block)) for block in blocks])

    def instantiate(self, picked: Sequence[tuple[int, Mapping[str, Any]]]) -> Iterator[Scene]:
        """The scenes of accepted candidates of a stream, in order."""
        numbered = [(index, *item) for index, item in enumerate(picked)]
        if self._jobs == 1 or len(numbered) < 8:
            yield from (self._worker.instantiate(*item) for item in numbered)
        else:
            pool = self._started()
            yield from _in_order([pool.submit(_instantiate, item) for item in numbered])

    def _started(self) -> ProcessPoolExecutor:
        if self._pool is None:
            worker = self._worker
            self._pool = ProcessPoolExecutor(
                self._jobs,
                # Spawned: a fork may copy the locked locks of threads that OpenCV has started.
                mp_context=multiprocessing.get_context("spawn"),
                initializer=_start,
                initargs=(worker.judge.scenario, worker.seed, worker.overrides),
            )
        return self._pool


_worker: Worker | None = None


def _start(scenario: IndexedScenario, seed: int, overrides: dict[str, str]) -> None:
    global _worker
    _worker = Worker(scenario, seed, overrides)


def _search(block: Block) -> Searched:
    assert _worker is not None
    return _worker.search(block)


def _instantiate(item: tuple[int, int, Mapping[str, Any]]) -> Scene:
    assert _worker is not None
    return _worker.instantiate(*item)


def _in_order(futures: Iterable[Future[Any]]) -> Iterator[Any]:
    for future in list(futures):
        yield future.result()
