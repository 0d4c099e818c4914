"""Samples that were recorded but not evaluated yet; many are read at once."""

from __future__ import annotations

import numpy as np

from ...geometry.arrays import Floats, Integers
from ..lanes.lane_columns import LANE_COLUMNS
from ..state.world import World
from .conditions import unsupported
from .lane_reader import LaneReader
from .recorded_samples import PLACES, RecordedSample, column_of, taken


class PendingSamples:
    """The samples of a world since the last `clear`. Columns are (K, R) over samples and agents."""

    def __init__(self, world: World) -> None:
        self._world = world
        self._agents = np.arange(len(world.present))
        """numbers of the agents in that world"""
        self._reader: LaneReader | None = None
        self.times: list[float] = []
        self._samples: list[RecordedSample] = []

    def add(self, time: float, sample: RecordedSample) -> None:
        """One more."""
        self.times.append(time)
        self._samples.append(sample)

    def clear(self) -> None:
        """All samples so far have been looked at."""
        self.times, self._samples = [], []

    def first(self, count: int) -> PendingSamples:
        """The first `count` of these samples alone, the last of which is now."""
        out = PendingSamples(self._world)
        out._agents, out._reader = self._agents, self._reader
        out.times, out._samples = self.times[:count], self._samples[:count]
        return out

    def time(self, depth: int) -> Floats:
        """(K,) seconds, of now and of at most `depth` samples before."""
        return np.array(self.times[-depth - 1 :])

    def column(self, name: str, agents: Integers, depth: int) -> Floats:
        """(K, R) a member of the `AgentTrace` of some agents; sizes are (R,). Raises RL513 for the
        acceleration, which depends on the next sample too."""
        if name in ("length", "width"):
            size: Floats = getattr(self._world.bodies, name)[self._agents[agents]]
            return size
        if name in LANE_COLUMNS:
            return self._lane_columns(agents, depth, name)
        if name not in PLACES:
            raise unsupported(name)
        return column_of(self._samples[-depth - 1 :], name, agents)

    def take(self, agents: Integers) -> None:
        """From now on the world has these of its agents alone."""
        self._agents = self._agents[agents]
        self._samples = taken(self._samples, agents)

    def _lane_columns(self, agents: Integers, depth: int, name: str) -> Floats:
        if self._reader is None:
            self._reader = LaneReader(self._world)
        rows = self._agents[agents]
        needed = self._reader.needed(rows)
        known = {column: self.column(column, agents, depth).T for column in needed}
        return self._reader.read(rows, known, (name,))[name].T
