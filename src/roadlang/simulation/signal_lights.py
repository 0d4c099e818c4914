"""The signals of junctions over time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..geometry.arrays import Booleans, Floats, Integers
from ..ir.scene_junctions import SceneJunction


@dataclass(frozen=True)
class Lights:
    """What the connections of some junctions show, at any time.

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
    end: Floats
    """(C, P) ... when its yellow begins; infinite where it has none of P greens"""
    yellow: Floats
    """(C, P) seconds"""
    junction: Integers
    """(C,)"""

    @classmethod
    def of(cls, junctions: Sequence[SceneJunction]) -> Lights:
        """Those of junctions, some of which may have none."""
        counts = [len(junction.connections) for junction in junctions]
        first = np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
        most = max(1, *(len(junction.control.phases) for junction in junctions), 1)
        shape = int(first[-1]), most
        begin, end, yellow = np.full(shape, math.inf), np.full(shape, math.inf), np.zeros(shape)
        cycles, offsets, signals = [], [], []
        for number, junction in enumerate(junctions):
            places = {one.id: place for place, one in enumerate(junction.connections)}
            at = 0.0
            for index, phase in enumerate(junction.control.phases):
                rows = [int(first[number]) + places[id] for id in phase.connections]
                begin[rows, index], end[rows, index] = at, at + phase.green
                yellow[rows, index] = phase.yellow
                at += phase.green + phase.yellow + phase.all_red
            signals.append(junction.control.kind == "signals" and at > 0.0)
            cycles.append(at if signals[-1] else 1.0)
            offsets.append(junction.control.offset)
        return cls(
            first[:-1], np.array(cycles), np.array(offsets), np.array(signals, dtype=bool),
            begin, end, yellow, np.repeat(np.arange(len(counts)), counts),
        )  # fmt: skip

    def at(self, time: float) -> tuple[Booleans, Floats]:
        """(C,) which connections have green, and the seconds until red: 0 at red, infinite where
        there are no signals."""
        phase = np.mod(time + self.offset, self.cycle)[self.junction][:, None]
        green = (self.begin <= phase) & (phase < self.end)
        lit = (self.begin <= phase) & (phase < self.end + self.yellow)
        left = np.where(lit, self.end + self.yellow - phase, 0.0).max(axis=1)
        signals = self.has_signals[self.junction]
        return green.any(axis=1) | ~signals, np.where(signals, left, math.inf)
