"""How many rounds of a search are evaluated together."""

from __future__ import annotations

from ..search.worker_pool import WorkerPool
from .deadline import now
from .evaluator import Evaluator
from .plan import Plan

_LONGEST_PART = 5.0
"""Seconds that a worker may be busy with a whole round: so much is lost with it, and so late a
search sees that its time is over."""


class Lookahead:
    """A searcher that uses no results need not wait for them: then every worker has a round for
    itself, since a simulator drives a whole one in little more time than a part of it. Where drives
    take long, a round is divided among all workers as that of other searchers is; so it is where
    the search ends with a number of failures, after which nothing is evaluated.

    How long they take says the clock, but no result depends on what is evaluated together.
    """

    def __init__(self, plan: Plan, pool: WorkerPool[Evaluator]) -> None:
        waits = plan.searcher.is_adaptive or plan.failures is not None
        self._most = 1 if waits else pool.workers
        self._batch = plan.batch
        self._workers = pool.workers
        self._seconds: float | None = None
        """of a whole round by one worker, as the last ones took"""
        self._began = 0.0

    def begin(self) -> int:
        """The number of rounds that are to be evaluated now: one before anything is known."""
        self._began = now()
        is_quick = self._seconds is not None and self._seconds <= _LONGEST_PART
        return self._most if is_quick else 1

    def end(self, candidates: int) -> None:
        """So many candidates were evaluated since it began."""
        each = (now() - self._began) * self._workers / max(candidates, 1)
        self._seconds = each * self._batch
