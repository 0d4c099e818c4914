"""Drives of many scenes, a part after the other, by several processes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain
from typing import TYPE_CHECKING

from ..drive.batches import DriveTask
from ..search.worker_pool import ALONE, WorkerPool, Workers
from ..simulation.vehicles import compiled
from .drives import Drive, DriveSet

if TYPE_CHECKING:
    from .scene import Scene

_FEW, _MANY = 8, 128
"""Scenes that are driven here before processes are forked, and of how many: of fewer, loading what
is compiled would take longer than it saves."""
_SIDE_BY_SIDE = 64
"""Scenes that `compiled.expect` counts as driven side by side."""


def drive_in_parts(
    scenes: Sequence[Scene],
    task: DriveTask,
    workers: Workers = ALONE,
) -> Iterator[DriveSet]:
    """The drives of parts of the scenes, in order, each part as soon as it and those before it are
    done. Before processes are forked a few scenes are driven here, so that what drives them is
    loaded once for all."""
    each = [scene.record for scene in scenes]
    with WorkerPool(task, workers) as pool:
        is_worth_it = pool.will_fork and len(each) >= _MANY
        here = task.first_part(each, _FEW) if is_worth_it else range(0)
        parts = [*([here] if here else []), *task.parts(each, workers.jobs, len(here))]
        records = [[each[number] for number in part] for part in parts]
        jobs = (records[:1], records[1:]) if here else (records,)
        if here:
            compiled.expect(len(scenes) / _SIDE_BY_SIDE)
        done = chain.from_iterable(pool.map(DriveTask.drive, some) for some in jobs)
        for part, driven in zip(parts, done, strict=True):
            pairs = zip(part, driven, strict=True)
            yield DriveSet(Drive(scenes[number], found, task.places) for number, found in pairs)
