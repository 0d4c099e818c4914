"""Samples whose columns are computed later, for many of them at once."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ...geometry.arrays import Floats
from ..signals.columns import COLUMNS
from ..signals.recorded_samples import RECORDED, RecordedSample
from ..state.world import World
from ..vehicles.motion import MOTION_COLUMNS
from ..vehicles.poses import Poses

AT_ONCE = 8192
"""Agents at times that are computed together: their columns fit into the caches."""
_RECORDED = tuple(COLUMNS[name] for name in RECORDED)
_KEPT = ("contacts", "red_lights", "collision")
"""Columns that worlds change in place."""


def columns_now(world: World, poses: Poses) -> Iterator[Floats]:
    """(N,) each of the quantities `RECORDED`."""
    for column in _RECORDED:
        yield column(world, poses)


class LaterSamples:
    """Samples of one world at several times."""

    def __init__(self) -> None:
        self._worlds: list[World] = []
        self._places: list[int] = []
        self._kept: list[list[Floats]] = []

    @property
    def is_full(self) -> bool:
        """Whether it is time to `fill`."""
        return bool(self._worlds) and len(self._worlds) * len(self._worlds[0].present) >= AT_ONCE

    def add(self, place: int, world: World) -> None:
        """The sample at a place is of the world as it is now. Its motion and its columns are not
        changed any more, but for those that are kept here; its lines have no guides."""
        self._worlds.append(world)
        self._places.append(place)
        offset = world.followed.lateral.offset
        self._kept.append([offset.copy(), *(getattr(world, name).copy() for name in _KEPT)])

    def fill(self, samples: list[RecordedSample]) -> None:
        """Put all samples so far at their places."""
        if not self._worlds:
            return
        every = self._side_by_side()
        out = np.empty((len(self._worlds), len(RECORDED), len(self._worlds[0].present)))
        for number, column in enumerate(columns_now(every, every.poses)):
            out[:, number] = column.reshape(len(out), -1)
        for place, sample in zip(self._places, out, strict=True):
            samples[place] = RecordedSample(sample)
        self._worlds, self._places, self._kept = [], [], []

    def _side_by_side(self) -> World:
        """The worlds as scenes of one."""
        worlds = self._worlds
        every = worlds[0].take(np.tile(np.arange(len(worlds[0].scenes)), len(worlds)))
        for name in MOTION_COLUMNS:
            setattr(every.motion, name, np.concatenate([getattr(w.motion, name) for w in worlds]))
        along, traveled = every.motion.along, np.concatenate([w.traveled for w in worlds])
        every.traveled, every.present = traveled, np.concatenate([w.present for w in worlds])
        every.arrived = along, traveled, np.concatenate([w.at_end for w in worlds])
        offset, *kept = (np.concatenate(column) for column in zip(*self._kept, strict=True))
        every.followed.lateral.offset = offset
        for name, column in zip(_KEPT, kept, strict=True):
            setattr(every, name, column)
        return every
