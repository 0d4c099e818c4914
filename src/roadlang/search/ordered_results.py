"""Results of jobs that others work on, in the order of the jobs."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Sequence
from typing import Any, Protocol

_AHEAD = 3
"""Jobs for each worker that are submitted, while the results of others are waited for."""


class Future(Protocol):
    """What an executor gives for a job."""

    def result(self) -> Any:
        """The result, waited for."""
        ...


def results_in_order(
    submit: Callable[[Any], Future], jobs: Sequence[Any], workers: int
) -> Iterator[Any]:
    """Results in order. Not all jobs are submitted at once: results that nobody has taken yet
    would fill the memory."""
    ahead: deque[Future] = deque()
    for job in jobs:
        ahead.append(submit(job))
        if len(ahead) > _AHEAD * workers:
            yield ahead.popleft().result()
    while ahead:
        yield ahead.popleft().result()
