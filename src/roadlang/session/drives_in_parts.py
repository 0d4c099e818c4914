"""Drives of many scenes, a part after the other, by several processes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain
from typing import TYPE_CHECKING

from ..search.worker_pool import ALONE, WorkerPool, Workers
from ..simulation.vehicles import compiled
from .finished_drives import DriveFinishing, FinishedDrive

if TYPE_CHECKING:
    from .scene import Scene

_FEW, _MANY = 8, 128
"""Scenes that are driven here before processes are forked, and of how many: of fewer, loading what
is compiled would take longer than it saves."""
_SIDE_BY_SIDE = 64
"""Scenes that `compiled.expect` counts as driven side by side."""


def drive_in_parts(
    scenes: Sequence[Scene],
    finishing: DriveFinishing,
    workers: Workers = ALONE,
) -> Iterator[list[FinishedDrive]]:
    """The drives of parts of the scenes with their files, in order, each part as soon as it and
    those before it are done. Before processes are forked a few scenes are driven here, so that what
    drives them is loaded once for all."""
    each, task = [scene.record for scene in scenes], finishing.task
    with WorkerPool(finishing, workers) as pool:
        is_worth_it = pool.will_fork and len(each) >= _MANY
        here = task.first_part(each, _FEW) if is_worth_it else range(0)
        parts = [*([here] if here else []), *task.parts(each, workers.jobs, len(here))]
        records = [[each[number] for number in part] for part in parts]
        jobs = (records[:1], records[1:]) if here else (records,)
        if here:
            compiled.expect(len(scenes) / _SIDE_BY_SIDE)
        yield from chain.from_iterable(pool.map(DriveFinishing.finish, some) for some in jobs)
