"""The last samples of a world while it is driven: what `when:` and `while:` are measured on."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from dataclasses import fields

import numpy as np

from ...geometry.arrays import Floats, Integers, read_only
from ...ir.road_heights import standing_trace
from ...ir.trace import AgentTrace, Trace
from ..lanes.lane_columns import LANE_COLUMNS
from ..state.world import World
from ..vehicles.poses import Poses
from .columns import COLUMNS
from .lane_reader import LaneReader

_SIZES = ("length", "width")
_RECORDED = tuple(
    field.name for field in fields(AgentTrace) if field.name in COLUMNS and field.name not in _SIZES
)


class Samples:
    """The sample of now and `depth` before it, which may be infinite.

    Columns are (K, N) over samples and agents, the last row is now.
    """

    def __init__(self, depth: float, spacing: float | None = None) -> None:
        """`spacing`: seconds from one sample to the next, if time is counted from now."""
        longest = None if math.isinf(depth) else int(depth)
        self._depth = depth
        self._spacing = spacing
        self._spaced: dict[int, Floats] = {}  # times of so many samples
        self._times: deque[float] = deque(maxlen=None if longest is None else longest + 1)
        self._past: deque[dict[str, Floats]] = deque(maxlen=longest)
        self._now: dict[str, Floats] = {}
        self._traces: dict[int, Trace] = {}
        self._reader: LaneReader | None = None
        self._index = np.zeros(0, dtype=np.int64)

    def add(self, world: World, poses: Poses) -> None:
        """The world as it is now."""
        if self._depth != 0 and self._times:
            self._past.append(self._now)
        self._world, self._poses = world, poses
        self._times.append(world.time)
        self._now, self._traces = {}, {}
        if self._depth != 0:  # the world goes on from here
            self._now = {name: self._present(name) for name in COLUMNS}

    def restart(self, agents: Integers, world: World, poses: Poses) -> None:
        """Some agents are back at the start: there was nothing before now."""
        if self._depth == 0:
            return
        for name, column in COLUMNS.items():
            now = column(world, poses)
            for values in (*(past[name] for past in self._past), self._now[name]):
                values[agents] = now[agents]

    def carry_on(self, before: Samples) -> None:
        """Go on after the samples of another, of the same agents and at least as deep."""
        if before._depth >= self._depth > 0:
            self._times.extend(before._times)
            self._past.extend(before._past)
            self._now = before._now

    def take(self, agents: Integers) -> None:
        """From now on the world has these of its agents alone."""
        for number, past in enumerate(self._past):
            self._past[number] = {name: column[agents] for name, column in past.items()}
        self._now = {name: column[agents] for name, column in self._now.items()}
        self._index = self._index[agents] if self._reader is not None else self._index

    def time(self, depth: int) -> Floats:
        """(K,) seconds, of now and of at most `depth` samples before."""
        if self._spacing is not None:
            count = min(len(self._times), depth + 1)
            if count not in self._spaced:
                spaced = np.arange(1 - count, 1, dtype=np.float64) * self._spacing
                self._spaced[count] = read_only(spaced)
            return self._spaced[count]
        return np.array(self._times)[-depth - 1 :]

    def column(self, name: str, agents: Integers, depth: int) -> Floats:
        """(K, R) a member of the `AgentTrace` of some agents; sizes are (R,)."""
        if name in LANE_COLUMNS:
            return self._lane_columns(agents, depth, (name,))[name]
        now = self._present(name)[agents]
        if name in _SIZES:
            return now
        if not depth or not self._past:
            return np.asarray(now[None])
        before = list(self._past)[max(len(self._past) - depth, 0) :]
        found = np.stack([*(past[name][agents] for past in before), now])
        return np.unwrap(found, axis=0) if name == "heading" and len(found) > 1 else found

    def now(self, name: str, agents: Integers) -> Floats:
        """(R,) what `column` gives of now, of one of `COLUMNS`, when only few agents are asked
        for."""
        known = self._now.get(name)
        values: Floats = COLUMNS[name](self._world, self._poses) if known is None else known
        return values[agents]

    def trace(self, scene: int) -> Trace:
        """A scene up to now, its agents and objects."""
        if scene not in self._traces:
            time = np.array(self._times)
            record, first = self._world.scenes[scene], scene * self._world.slots
            rows = first + np.arange(len(record.agents))
            columns = {name: self.column(name, rows, len(time)) for name in _RECORDED}
            columns |= self._lane_columns(rows, len(time), LANE_COLUMNS)
            agents = {
                actor.name: AgentTrace(
                    name=actor.name,
                    time=time,
                    length=actor.length,
                    width=actor.width,
                    **{name: column[:, slot] for name, column in columns.items()},
                )
                for slot, actor in enumerate(record.agents)
            }
            agents |= {one.name: standing_trace(record, one, time) for one in record.standing}
            self._traces[scene] = Trace(time, agents, "the embedded engine")
        return self._traces[scene]

    def _present(self, name: str) -> Floats:
        if name not in self._now:
            self._now[name] = np.array(COLUMNS[name](self._world, self._poses))
        return self._now[name]

    def _lane_columns(
        self, agents: Integers, depth: int, names: Sequence[str]
    ) -> dict[str, Floats]:
        """(K, R) some of `LANE_COLUMNS`, of some agents."""
        if self._reader is None:
            self._reader = LaneReader(self._world)
            self._index = np.arange(len(self._world.present))
        rows = self._index[agents]
        needed = self._reader.needed(rows)
        known = {name: self.column(name, agents, depth).T for name in needed}
        found = self._reader.read(rows, known, names)
        return {name: values.T for name, values in found.items()}
