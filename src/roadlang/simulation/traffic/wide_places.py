"""Where on their lines vehicles may need more than their lanes: what is not near need not be
sampled."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...geometry.arrays import Booleans, Floats, Integers
from ...geometry.curves.bend_room import LONG, PASSING_GAP
from ..bends.sweeps import Sweeps
from ..state.world import World

VIEW = 40.0
"""Meters ahead in which such places are looked for."""
LEAST_SWEPT = 0.2
"""Meters: long vehicles that cover less beyond their width fit everywhere, others where they cover
no more than their lane."""
ROUNDING = 0.01
"""Meters by which a place may be off."""


def is_wide(world: World, agents: Integers, swept: Floats, road_width: Floats) -> Booleans:
    """(M, I) where agents (I,) may need more than their lanes, which are as wide as this; `swept`:
    what they cover beyond their width."""
    half = 0.5 * world.bodies.width[agents]
    in_lane = world.has_route[agents] & (world.bodies.length[agents] <= LONG)
    spare = np.where(in_lane, 0.5 * road_width - half - 0.5 * PASSING_GAP, 0.0)
    return np.asarray(swept > np.maximum(spare, LEAST_SWEPT))


@dataclass(frozen=True)
class WidePlaces:
    """How many cells of a line are such places, of those before each: (T, M + 1), in the order of
    the tables of `Sweeps`."""

    sweeps: Sweeps
    counts: NDArray[np.int32]

    @classmethod
    def of(cls, world: World) -> WidePlaces:
        """Of the lines of a world."""
        sweeps, lines = world.sweeps, world.track.lines
        counts = np.zeros((len(sweeps.left), lines.cells + 1), dtype=np.int32)
        for table in np.unique(sweeps.table).tolist():
            mates = np.flatnonzero(sweeps.table == table)
            free = mates[~world.has_route[mates]]  # who has no lane needs more than it more often
            agent = free[:1] if len(free) else mates[:1]
            first = int(world.track.first[agent[0]])
            width = lines.width[first : first + lines.cells, None]
            swept = np.maximum(sweeps.left[table], sweeps.right[table])[:, None]
            np.cumsum(is_wide(world, agent, swept, width)[:, 0], out=counts[table, 1:])
        return cls(sweeps, counts)

    def holds(self, sweeps: Sweeps) -> bool:
        """Whether these are still the tables of a world."""
        return self.sweeps.left is sweeps.left

    def may_be_ahead(self, world: World) -> Booleans:
        """(N,) who may come to such a place in its view, or be in one. False is certain."""
        track, table = world.track, world.sweeps.table
        along, around = world.motion.along, 0.5 * world.bodies.length + ROUNDING
        first = track.cell(along - around)[0] - track.first
        last = track.cell(along + around + VIEW)[0] - track.first + 1
        found: Booleans = self.counts[table, last] > self.counts[table, first]
        return found | (track.closed & (table > 0)) if track.has_closed else found
