"""Work on many jobs, in this process or in others; the results and their order are the same."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any, Generic, Protocol, TypeVar

from ..diagnostics import Code, Diagnostic, DiagnosticError
from .ordered_results import Future, results_in_order
from .start_method import FORK, start_method
from .working import worked

if TYPE_CHECKING:
    from .worker_processes import WorkerProcesses

State = TypeVar("State")
Job = TypeVar("Job")
Result = TypeVar("Result")


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

    @property
    def write_here(self) -> bool:
        """Whether there are other processes that see the disks of this machine: what they write
        need not be sent. Those of an executor may be elsewhere."""
        return self.jobs > 1 and self.executor is None


ALONE = Workers()


class WorkerPool(Generic[State]):
    """Holds `state` here and, with several workers, a copy of it in each of as many processes.

    The state is pickled, once for each process, when the first work is handed out to them. With an
    executor the jobs are submitted to that, each with the state, of which every worker keeps one
    copy.
    """

    def __init__(self, state: State, workers: Workers = ALONE) -> None:
        self.state = state
        """what the jobs share, as it is here"""
        self._count = max(1, workers.jobs)
        self._cluster = workers.executor
        self._processes: WorkerProcesses | None = None

    def __enter__(self) -> WorkerPool[State]:
        return self

    def __exit__(self, kind: type[BaseException] | None, *error: object) -> None:
        if self._processes is not None:
            self._processes.end(at_once=kind is not None)

    @property
    def workers(self) -> int:
        """How many jobs are worked on at a time."""
        return self._count

    @property
    def will_fork(self) -> bool:
        """Whether processes are still to be started that are copies of this one: what is loaded
        here before need not be loaded by each of them."""
        is_open = self._count > 1 and self._cluster is None and self._processes is None
        return is_open and start_method() == FORK

    def map(
        self, work: Callable[[State, Job], Result], jobs: Sequence[Job], fewest: int = 2
    ) -> Iterator[Result]:
        """`work(state, job)` of each job, in order; of fewer than `fewest` jobs in this process.

        `work` is a function of a module or class, as other processes find it by its name. A job
        whose process died is done again by another. Raises `BrokenExecutor` where that happens
        again and again.
        """
        if self._cluster is not None:
            shared = _Shared(self.state)
            submit = partial(self._cluster.submit, _run_shared, shared, work)
            try:
                yield from results_in_order(submit, jobs, self._count)
            except DiagnosticError as error:
                raise DiagnosticError(*map(_as_of_a_worker, error.diagnostics)) from error
        elif self._count == 1 or len(jobs) < fewest:
            yield from (worked(work, self.state, job) for job in jobs)
        else:
            if self._processes is None:
                from .worker_processes import WorkerProcesses

                self._processes = WorkerProcesses(self.state, self._count)
            yield from self._processes.map(work, jobs)


def _as_of_a_worker(found: Diagnostic) -> Diagnostic:
    """A file that cannot be read elsewhere may well be there on this machine."""
    if found.code != Code.UNREADABLE_INPUT:
        return found
    where = "workers read input files themselves, at the same path as on this machine: put it on a"
    return replace(found, help=(*found.help, f"{where} file system that all of them share"))


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
    return worked(work, shared.state, job)
