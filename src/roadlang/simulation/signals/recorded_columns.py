"""Columns of recorded drives, made of the samples of many agents when one of them is first read."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...geometry.arrays import Floats, Integers, read_only
from ..lanes.lane_columns import LANE_COLUMNS
from .lane_reader import LaneReader
from .recorded_samples import RECORDED, RecordedSample, column_of

_LANE_PLACES = {name: place for place, name in enumerate(LANE_COLUMNS)}


class RecordedPart:
    """Samples of the agents of a world for some time, in which they were the same."""

    def __init__(
        self, samples: Sequence[RecordedSample], agents: Integers, lanes: LaneReader
    ) -> None:
        """`samples`: of each time; `agents`: (N,) numbers of the agents in the first world."""
        self._samples = samples
        self._agents = agents
        self._lanes = lanes
        self._known: dict[str, Floats] = {}
        self.count = len(samples)
        """how many times it has"""

    def column(self, agent: int, name: str) -> Floats:
        """(T,) of one of its N agents."""
        if name in _LANE_PLACES:
            values: Floats = self._lane_columns[agent, _LANE_PLACES[name]]
            return values
        of_agent: Floats = self._columns(name)[agent]
        return of_agent

    def _columns(self, name: str) -> Floats:
        """(N, T) one of the quantities `RECORDED`: most drives of a search are asked for few."""
        if name not in self._known:
            values = column_of(self._samples, name)
            self._known[name] = read_only(np.ascontiguousarray(values.T))
            if len(self._known) == len(RECORDED):
                self._samples = ()
        return self._known[name]

    @cached_property
    def _lane_columns(self) -> Floats:
        """(N, Q, T) with the quantities `LANE_COLUMNS`."""
        known = {name: self._columns(name) for name in self._lanes.needed(self._agents)}
        found = self._lanes.read(self._agents, known)
        return read_only(np.stack([found[name] for name in LANE_COLUMNS], axis=1))


@dataclass(frozen=True)
class RecordedAgent:
    """The members of the `AgentTrace` of one agent, by their names."""

    time: Floats
    """(T,); there may be later samples"""
    parts: tuple[tuple[RecordedPart, int], ...]
    """one after another, with the number of the agent in each"""

    def __call__(self, name: str) -> Floats:
        """(T,) a member."""
        if name == "acceleration":
            return read_only(self._acceleration())
        found = [part.column(agent, name) for part, agent in self.parts]
        values = (found[0] if len(found) == 1 else np.concatenate(found))[: len(self.time)]
        return read_only(_unwrapped(values) if name == "heading" else values)

    def _acceleration(self) -> Floats:
        """The derivative of the speed; of who has left as it was last."""
        speed, gone = self("speed"), self("present") == 0.0
        there = int(gone.argmax()) or len(gone)
        found = _rate(speed[:there], self.time[:there])
        return np.concatenate([found, np.full(len(gone) - there, found[-1])])


def _unwrapped(heading: Floats) -> Floats:
    """The same where it does not jump by a turn."""
    jumps = (np.abs(heading[1:] - heading[:-1]) > np.pi).any()
    return np.unwrap(heading) if jumps else heading


def _rate(values: Floats, time: Floats) -> Floats:
    """Derivative by central differences, at the ends one-sided."""
    if len(time) < 2:
        return np.zeros(len(time))
    out = np.empty(len(time))
    out[1:-1] = (values[2:] - values[:-2]) / (time[2:] - time[:-2])
    out[0] = (values[1] - values[0]) / (time[1] - time[0])
    out[-1] = (values[-1] - values[-2]) / (time[-1] - time[-2])
    return out
