"""Work on many jobs, in this process or in others; the results and their order are the same."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from typing import Any, Generic, TypeVar

State = TypeVar("State")
Job = TypeVar("Job")
Result = TypeVar("Result")


class WorkerPool(Generic[State]):
    """Holds `state` here and, with `processes` above 1, a copy of it in each of as many processes.

    The state is pickled, once for each process, when the first work is handed out to them.
    """

    def __init__(self, state: State, processes: int) -> None:
        self._state = state
        self._processes = max(1, processes)
        self._executor: ProcessPoolExecutor | None = None
        self._other_children = frozenset(multiprocessing.active_children())

    def __enter__(self) -> WorkerPool[State]:
        return self

    def __exit__(self, kind: type[BaseException] | None, *error: object) -> None:
        if self._executor is None:
            return
        if kind is not None:  # nobody waits for what the workers are doing
            for process in set(multiprocessing.active_children()) - self._other_children:
                process.terminate()
        self._executor.shutdown(wait=True, cancel_futures=True)

    def map(
        self, work: Callable[[State, Job], Result], jobs: Sequence[Job], fewest: int = 2
    ) -> Iterator[Result]:
        """`work(state, job)` of each job, in order; of fewer than `fewest` jobs in this process.

        `work` is a function of a module or class, as other processes find it by its name.
        """
        if self._processes == 1 or len(jobs) < fewest:
            yield from (work(self._state, job) for job in jobs)
        else:
            executor = self._started()
            futures = [executor.submit(_run, work, job) for job in jobs]
            yield from (future.result() for future in futures)

    def _started(self) -> ProcessPoolExecutor:
        if self._executor is None:
            self._executor = ProcessPoolExecutor(
                self._processes,
                # Spawned: a fork may copy the locked locks of threads that OpenCV has started.
                mp_context=multiprocessing.get_context("spawn"),
                initializer=_start,
                initargs=(self._state,),
            )
        return self._executor


_process_state: list[Any] = []
"""The state of a worker process: an executor has no other place for what its jobs share.
Filled once, when the process starts; empty in the process that hands out the work."""


def _start(state: Any) -> None:
    _process_state.append(state)


def _run(work: Callable[[Any, Job], Result], job: Job) -> Result:
    return work(_process_state[0], job)
