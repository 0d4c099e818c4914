"""The signals of junctions over time: `SceneControl.light` for many connections and times."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene_junctions import SceneJunction


@dataclass(frozen=True)
class Lights:
    """What signals show the connections of some junctions, at any time.

    Connections are numbered through all junctions: that at place c of junction j is `first[j] + c`.
    """

    first: Integers
    """(J,)"""
    cycle: Floats
    """(J,) seconds of all phases; 1 without signals"""
    offset: Floats
    has_signals: Booleans
    """(J,)"""
    begin: Floats
    """(C, P) when a connection gets green in a cycle, and ..."""
    yellow: Floats
    """(C, P) ... when its yellow begins, and ..."""
    red: Floats
    """(C, P) ... its red; all are infinite where it has none of P greens"""
    junction: Integers
    """(C,)"""

    @classmethod
    def of(cls, junctions: Sequence[SceneJunction]) -> Lights:
        """Those of junctions, some of which may have none."""
        counts = [len(junction.connections) for junction in junctions]
        first = np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
        most = max(1, *(len(junction.control.phases) for junction in junctions), 1)
        shape = int(first[-1]), most
        begin, yellow, red = (np.full(shape, math.inf) for _ in range(3))
        cycles, offsets, signals = [], [], []
        for number, junction in enumerate(junctions):
            places = {connection.id: place for place, connection in enumerate(junction.connections)}
            control = junction.control
            for index, (phase, times) in enumerate(
                zip(control.phases, control.changes, strict=True)
            ):
                rows = [int(first[number]) + places[id] for id in phase.connections]
                begin[rows, index], yellow[rows, index], red[rows, index] = times[:3]
            signals.append(control.kind == "signals" and control.cycle > 0.0)
            cycles.append(control.cycle if signals[-1] else 1.0)
            offsets.append(control.offset)
        return cls(
            first[:-1], np.array(cycles), np.array(offsets), np.array(signals, dtype=bool),
            begin, yellow, red, np.repeat(np.arange(len(counts)), counts),
        )  # fmt: skip

    def shown(self, connections: Integers) -> ShownLights:
        """What is shown to some connections, in an array of any shape."""
        junction = self.junction[connections]
        return ShownLights(
            self.cycle[junction], self.offset[junction], self.has_signals[junction],
            self.begin[connections], self.yellow[connections], self.red[connections],
        )  # fmt: skip

    def at(self, connections: Integers, time: Floats) -> tuple[Booleans, Floats]:
        """Which of some connections have green, and the seconds until red: 0 at red, infinite where
        there are no signals.

        `time`: seconds into the drive, one for each of `connections`, or of a shape that numpy
        broadcasts to theirs.
        """
        return self.shown(connections).at(time)

    def is_red(self, connections: Integers, time: Floats) -> Booleans:
        """Whether signals show them red; never where there are none."""
        return np.asarray(self.at(connections, time)[1] <= 0.0)


@dataclass(frozen=True)
class ShownLights:
    """What signals show some connections, arrays of one shape; those of times have an axis more."""

    cycle: Floats
    offset: Floats
    has_signals: Booleans
    begin: Floats
    yellow: Floats
    red: Floats

    @property
    def members(self) -> tuple[Any, ...]:
        """All of them, in their order."""
        return self.cycle, self.offset, self.has_signals, self.begin, self.yellow, self.red

    @cached_property
    def _any(self) -> bool:
        return bool(self.has_signals.any())

    def at(self, time: Floats) -> tuple[Booleans, Floats]:
        """The same as `Lights.at`."""
        if not self._any:
            return np.ones(self.cycle.shape, dtype=bool), np.full(self.cycle.shape, math.inf)
        now = np.mod(time + self.offset, self.cycle)[..., None]
        started = self.begin <= now
        green = (started & (now < self.yellow)).any(axis=-1)
        left = np.where(started & (now < self.red), self.red - now, 0.0).max(axis=-1)
        return green | ~self.has_signals, np.where(self.has_signals, left, math.inf)
