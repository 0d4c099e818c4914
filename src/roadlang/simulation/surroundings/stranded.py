"""Agents that stand in the way and wait for nothing: broken-down cars, and those that had a crash.

Traffic takes them for objects. Who waits for a light, for others or in a queue is not among them.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..state.world import World
from .due_scenes import due_scenes

INTERVAL = 0.1
"""Seconds from one look at a scene to the next."""
STILL, PATIENCE = 0.1, 5.0
"""m/s, ahead or back, and seconds for which who is slower has to stand until it counts as broken
down."""
SUSPECT, SPARE = 1.0, 1.3
"""Seconds from which on that may be, and meters more that others keep behind it: to pull out."""
BEHIND = 12.0
"""Meters: with somebody or something so close ahead an agent stands in a queue."""
BEFORE_LINE = 15.0
"""Meters before a junction up to which an agent may wait for it."""


@dataclass(frozen=True)
class Reasons:
    """Columns (n,) of some agents: why they may stand."""

    ahead: Floats
    """gap to the next agent or object"""
    to_line: Floats
    """meters to the next junction, negative on it"""


class Stranded:
    """Which agents of a world are stranded, brought up to date as they are asked for."""

    def __init__(self, world: World) -> None:
        count = len(world.present)
        self._stood = np.zeros(count)
        self._looked = np.full(len(world.scenes), -math.inf)
        self.agents: Booleans = np.zeros(count, dtype=bool)
        """(N,)"""
        self.suspects: Booleans = np.zeros(count, dtype=bool)
        """(N,) who may be"""

    def take(self, agents: Integers, scenes: Integers) -> None:
        """From now on the world has these of its agents and scenes alone."""
        self._stood, self._looked = self._stood[agents], self._looked[scenes]
        self.agents, self.suspects = self.agents[agents], self.suspects[agents]

    def look(
        self, world: World, rows: Integers, obeys: Booleans,
        reasons: Callable[[Integers], Reasons],
    ) -> bool:  # fmt: skip
        """Bring the scenes of some agents up to date; whether that changes who is stranded. Who
        `obeys` (N,) right of way says itself where it stops. `reasons`: of others that have stood
        for long."""
        scenes, agents = due_scenes(world, rows, self._looked, INTERVAL)
        if not len(scenes):
            return False
        self._looked[scenes] = world.time
        may = ((world.halted | ~obeys) & world.present & ~world.bodies.walks)[agents]
        if not np.count_nonzero(may):
            changes = bool(self.agents[agents].any())
            self._stood[agents] = 0.0
            self.agents[agents] = self.suspects[agents] = False
            return changes
        return self._update(world, agents, may, reasons)

    def _update(
        self, world: World, agents: Integers, may: Booleans,
        reasons: Callable[[Integers], Reasons],
    ) -> bool:  # fmt: skip
        still = may & (np.abs(world.motion.speed) < STILL)[agents]
        stood = np.where(still, self._stood[agents] + INTERVAL, 0.0)
        self._stood[agents] = stood = np.minimum(stood, world.age[agents])
        self.suspects[agents] = stood >= SUSPECT
        before, now = self.agents[agents], stood >= PATIENCE
        if np.count_nonzero(now):
            long = agents[now]
            why = reasons(long)
            idle = (why.to_line >= BEFORE_LINE) & (why.ahead > BEHIND)
            now[now] = world.halted[long] | idle
        self.agents[agents] = now
        return not np.array_equal(before, now)
