"""Work on many jobs, in this process or in others; the results and their order are the same."""

from __future__ import annotations

import multiprocessing
import os
import threading
from collections import OrderedDict, deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import BrokenExecutor, ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from typing import Any, Generic, Protocol, TypeVar

State = TypeVar("State")
Job = TypeVar("Job")
Result = TypeVar("Result")
_AHEAD = 3
"""Jobs for each worker that are submitted, while the results of others are waited for."""
_RESTARTS = 3
"""How often processes that died are replaced before the work is given up."""


class Future(Protocol):
    """What an executor gives for a job."""

    def result(self) -> Any:
        """The result, waited for."""
        ...


class Executor(Protocol):
    """Anything that runs functions elsewhere: of `concurrent.futures`, Dask, joblib, mpi4py."""

    def submit(self, function: Callable[..., Any], /, *arguments: Any) -> Future:
        """Run a function of picklable arguments."""
        ...


@dataclass(frozen=True)
class Workers:
    """Who does the work: `jobs` processes, or an `executor` with as many workers. `progress` is
    called with what is done and wanted."""

    jobs: int = 1
    executor: Executor | None = None
    progress: Callable[[int, int], None] | None = None


ALONE = Workers()


class WorkerPool(Generic[State]):
    """Holds `state` here and, with several workers, a copy of it in each of as many processes.

    The state is pickled, once for each process, when the first work is handed out to them. With an
    executor the jobs are submitted to that, each with the state, of which every worker keeps one
    copy.
    """

    def __init__(self, state: State, workers: Workers = ALONE) -> None:
        self._state = state
        self._processes = max(1, workers.jobs)
        self._cluster = workers.executor
        self._executor: ProcessPoolExecutor | None = None
        self._other_children = frozenset(multiprocessing.active_children())

    def __enter__(self) -> WorkerPool[State]:
        return self

    def __exit__(self, kind: type[BaseException] | None, *error: object) -> None:
        self._end(at_once=kind is not None)

    @property
    def workers(self) -> int:
        """How many jobs are worked on at a time."""
        return self._processes

    def map(
        self, work: Callable[[State, Job], Result], jobs: Sequence[Job], fewest: int = 2
    ) -> Iterator[Result]:
        """`work(state, job)` of each job, in order; of fewer than `fewest` jobs in this process.

        `work` is a function of a module or class, as other processes find it by its name. A job
        whose process died is done again by another. Raises `BrokenExecutor` where that happens
        again and again.
        """
        if self._cluster is not None:
            shared = _Shared(self._state)
            submit = partial(self._cluster.submit, _run_shared, shared, work)
            yield from _results(submit, jobs, self._processes)
        elif self._processes == 1 or len(jobs) < fewest:
            yield from (work(self._state, job) for job in jobs)
        else:
            yield from self._map_in_processes(work, jobs)

    def _map_in_processes(
        self, work: Callable[[State, Job], Result], jobs: Sequence[Job]
    ) -> Iterator[Result]:
        done, deaths = 0, 0
        while done < len(jobs):
            try:
                submit: Callable[..., Any] = self._started().submit
                for result in _results(partial(submit, _run, work), jobs[done:], self._processes):
                    done += 1
                    deaths = 0
                    yield result
            except BrokenExecutor:
                self._end(at_once=True)
                deaths += 1
                if deaths > _RESTARTS:
                    raise

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

    def _end(self, at_once: bool) -> None:
        if self._executor is None:
            return
        if at_once:  # nobody waits for what the workers are doing
            for process in set(multiprocessing.active_children()) - self._other_children:
                process.terminate()
        self._executor.shutdown(wait=True, cancel_futures=True)
        self._executor = None


def _results(submit: Callable[[Any], Future], jobs: Sequence[Any], workers: int) -> Iterator[Any]:
    """Results in order. Not all jobs are submitted at once: results that nobody has taken yet
    would fill the memory."""
    ahead: deque[Future] = deque()
    for job in jobs:
        ahead.append(submit(job))
        if len(ahead) > _AHEAD * workers:
            yield ahead.popleft().result()
    while ahead:
        yield ahead.popleft().result()


_process_state: list[Any] = []
"""The state of a worker process: an executor has no other place for what its jobs share.
Filled once, when the process starts; empty in the process that hands out the work."""


def _start(state: Any) -> None:
    _process_state.append(state)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    """A worker whose parent was killed would work on for nobody, and then wait forever."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _run(work: Callable[[Any, Job], Result], job: Job) -> Result:
    return work(_process_state[0], job)


@dataclass(frozen=True)
class _Shared:
    """A state that is sent with every job; a worker makes its own copy of it only once."""

    state: Any

    def __reduce__(self) -> tuple[Any, ...]:
        import pickle  # noqa: TID251 - what executors do with every argument

        content = pickle.dumps(self.state)
        return _unpacked, (content,)


_COPIES = 4
_copies: OrderedDict[bytes, _Shared] = OrderedDict()
"""The states that this process was sent last, by their content."""


def _unpacked(content: bytes) -> _Shared:
    import pickle  # noqa: TID251 - what executors do with every argument

    if content not in _copies:
        _copies[content] = _Shared(pickle.loads(content))
        while len(_copies) > _COPIES:
            _copies.popitem(last=False)
    return _copies[content]


def _run_shared(shared: _Shared, work: Callable[[Any, Job], Result], job: Job) -> Result:
    return work(shared.state, job)
