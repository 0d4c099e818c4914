"""Processes that work on jobs, each with a copy of what the jobs share."""

from __future__ import annotations

import gc
import multiprocessing
import os
import pickle  # noqa: TID251 - what processes do with every argument
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import BrokenExecutor, Future, ProcessPoolExecutor
from concurrent.futures import TimeoutError as NotYetDoneError
from dataclasses import dataclass
from functools import partial
from multiprocessing import resource_tracker
from multiprocessing.context import BaseContext
from multiprocessing.queues import SimpleQueue
from typing import Any

from ..plugins.termination import Terminated, end_on_sigterm
from .kept_memory import keep_memory
from .ordered_results import results_in_order
from .shared_state import Reference, SharedState, read
from .start_method import FORK, start_method
from .working import worked

_RESTARTS = 3
"""How often processes that died are replaced before the work is given up."""
_LOOK = 1.0
"""Seconds of waiting for a result before each look whether processes have died."""


class WorkerProcesses:
    """`count` processes, which are started when the first jobs are handed out to them."""

    def __init__(self, state: Any, count: int) -> None:
        self._state = state
        self._count = count
        self._executor: _Executor | None = None
        self._are_forked = False
        self._shared: SharedState | None = None
        self._other_children = frozenset(multiprocessing.active_children())
        self._seen: set[Any] = set()
        """our processes that were alive at the last look"""

    def map(self, work: Callable[[Any, Any], Any], jobs: Sequence[Any]) -> Iterator[Any]:
        """`work(state, job)` of each job, in order. A job whose process died is done again by
        another. Raises `BrokenExecutor` where that happens again and again."""
        done, deaths = 0, 0
        while done < len(jobs):
            try:
                rest = jobs[done:]
                submit = partial(self._submitted, *self._started(rest), work)
                for result in results_in_order(submit, range(len(rest)), self._count):
                    done += 1
                    deaths = 0
                    yield result
            except BrokenExecutor:
                self.end(at_once=True)
                deaths += 1
                if deaths > _RESTARTS:
                    raise

    def end(self, *, at_once: bool) -> None:
        """Ends the processes; `at_once` without waiting for what they are doing."""
        if self._executor is None:
            return
        if at_once:
            for process in self._alive():
                process.terminate()
            self._executor.results.write_no_more()
        self._executor.shutdown(wait=True, cancel_futures=True)
        self._executor = None
        self._seen = set()
        if self._shared is not None:
            self._shared.withdraw()
            self._shared = None

    def _alive(self) -> set[Any]:
        """The processes that were started for this work."""
        return set(multiprocessing.active_children()) - self._other_children

    def _submitted(self, *arguments: Any) -> _Watched:
        future = _submit(*arguments)
        self._seen |= self._alive()
        return _Watched(future, self._has_lost_some)

    def _has_lost_some(self) -> bool:
        """Whether a process has died since the last call. The executor notices this itself, unless
        the process was killed while it wrote a result: then it waits forever for the rest."""
        before, self._seen = self._seen, self._alive()
        return bool(before - self._seen)

    def _started(self, jobs: Sequence[Any]) -> tuple[_Executor, bool, Sequence[Any]]:
        """The processes, whether they are forked, and what `jobs` are called for them: those that
        are forked now have copies of all, by their numbers."""
        if self._executor is not None:
            return self._executor, self._are_forked, jobs
        method = start_method()
        self._are_forked = method == FORK
        self._shared = None if self._are_forked else SharedState(self._state)
        reference = pickle.dumps(self._state) if self._shared is None else self._shared.reference
        known = jobs if self._are_forked else ()
        context = multiprocessing.get_context(method)
        self._executor = _Executor(self._count, context, _start, (reference, known))
        named = [_Inherited(number) for number in range(len(jobs))] if self._are_forked else jobs
        return self._executor, self._are_forked, named


class _Results(SimpleQueue[Any]):
    """What processes send back."""

    def write_no_more(self) -> None:
        """Once no process can write, reading half a result, whose process was killed, fails instead
        of waiting forever. This process holds a writing end, too, which is not public: a Python
        that calls it something else still ends, unless half a result was sent."""
        writer = getattr(self, "_writer", None)
        if writer is not None:
            writer.close()


class _Executor(ProcessPoolExecutor):
    """An executor whose queue of results can be closed for writing."""

    def __init__(
        self, count: int, context: BaseContext, start: Callable[..., Any], known: tuple[Any, ...]
    ) -> None:
        super().__init__(count, mp_context=context, initializer=start, initargs=known)
        self.results = self._result_queue = _Results(ctx=context)


@dataclass(frozen=True)
class _Watched:
    """A result that nobody waits for in vain. `future` has it pickled; `has_lost_some`: has a
    process died since its last call?"""

    future: Future[Any]
    has_lost_some: Callable[[], bool]

    def result(self) -> Any:
        """The result. Raises `BrokenExecutor` where a process has died and it does not come."""
        is_lost = False
        while True:
            try:
                return pickle.loads(self.future.result(_LOOK))
            except NotYetDoneError:
                if self.future.done():  # meanwhile, or by this error
                    return pickle.loads(self.future.result())
            if is_lost:  # the executor had time to tell
                raise BrokenExecutor("a process was killed while it wrote a result")
            is_lost = self.has_lost_some()


@dataclass(frozen=True)
class _Inherited:
    """A job that a process has a copy of, by its number: it is not sent."""

    number: int


def _submit(
    executor: ProcessPoolExecutor,
    are_forked: bool,
    jobs: Sequence[Any],
    work: Callable[[Any, Any], Any],
    number: int,
) -> Future[Any]:
    """Hand out a job. A process that is started for it does not hear Ctrl-C, which goes to all
    processes of a terminal: whoever hands out the work ends it. Nor does one that is forked hear
    SIGTERM before it has let go of what is done here when that comes."""
    if not hasattr(signal, "pthread_sigmask"):  # Windows
        return executor.submit(_run, work, jobs[number])
    if not are_forked:
        resource_tracker.ensure_running()  # where it has to be started it lets signals through
    held = {signal.SIGINT, signal.SIGTERM} if are_forked else {signal.SIGINT}
    before = signal.pthread_sigmask(signal.SIG_BLOCK, held)
    try:
        return executor.submit(_run, work, jobs[number])
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


_CLEANING = 10.0
"""Seconds that a worker whose parent was killed may take to end the programs that it started."""
_process_state: list[Any] = []
"""The state of a worker process: an executor has no other place for what its jobs share.
Filled once, when the process starts; empty in the process that hands out the work."""
_process_jobs: list[Any] = []
"""The jobs that were known when it was forked."""
_is_idle = threading.Event()
"""Whether a worker process waits for a job."""


def _start(reference: Reference, jobs: Sequence[Any]) -> None:
    """Read the shared state, and keep the jobs that came with a fork."""
    gc.freeze()  # what came with a fork: to look through it would copy its memory
    keep_memory()
    # Not ignored: programs that are started from here would not hear it either.
    signal.signal(signal.SIGINT, lambda number, frame: None)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT, signal.SIGTERM})
    _process_state.append(read(reference))
    _process_jobs.extend(jobs)
    _is_idle.set()
    end_on_sigterm(_is_idle.is_set)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    """A worker whose parent was killed would work on for nobody, and then wait forever."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os.kill(os.getpid(), signal.SIGTERM)
        _is_idle.wait(_CLEANING)
        os._exit(1)


def _run(work: Callable[[Any, Any], Any], job: Any) -> bytes:
    """The result, pickled here: the executor would look up each object in more places first. What
    was started for a job, such as the programs of controllers, ends before the process does
    where SIGTERM breaks it off."""
    _is_idle.clear()
    try:
        known = _process_jobs[job.number] if isinstance(job, _Inherited) else job
        result = pickle.dumps(worked(work, _process_state[0], known))
    except Terminated:
        pass  # what the job held is freed with it, except for reference cycles
    except BaseException:
        _is_idle.set()
        raise
    else:
        _is_idle.set()
        return result
    gc.collect()
    # It ends here, where it holds no lock of the queue of results that others wait for.
    os._exit(128 + signal.SIGTERM)
