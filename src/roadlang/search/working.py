"""One job, whoever works on it."""

from __future__ import annotations

import gc
from collections.abc import Callable
from typing import TypeVar

State = TypeVar("State")
Job = TypeVar("Job")
Result = TypeVar("Result")


def worked(work: Callable[[State, Job], Result], state: State, job: Job) -> Result:
    """`work(state, job)`, without what it leaves behind. Batches of candidates and their roads
    refer to each other: few objects with much memory, which the collector, as commands set it,
    would look at only after many jobs. New memory takes the system longer than this look."""
    result = work(state, job)
    gc.collect(0)
    return result
