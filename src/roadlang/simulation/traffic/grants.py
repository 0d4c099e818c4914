"""Who may cross which junction, and since when: the memory of right of way."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats

NEVER = math.inf
FIRST = -1.0
"""The order of who does not obey: everybody lets it go first."""


@dataclass
class Grants:
    """Arrays (N, X) over the crossings of agents, changed as time goes on."""

    order: Floats
    """the time since which an agent may go, `NEVER`: it may not. Earlier ones go first"""
    arrival: Floats
    """when it expected to arrive at the line, as it first asked to go"""
    has_stopped: Booleans
    """at the line"""
    waiting: Floats
    """seconds that it has stood close to the line"""

    @classmethod
    def none(cls, shape: tuple[int, ...]) -> Grants:
        """Nobody may go."""
        never = np.full(shape, NEVER)
        return cls(never, never.copy(), np.zeros(shape, dtype=bool), np.zeros(shape))

    def take(self, rows: Any) -> Grants:
        """Those of some agents, in separate arrays."""
        return Grants(
            self.order[rows], self.arrival[rows], self.has_stopped[rows], self.waiting[rows]
        )

    def part(self, rows: Any) -> Grants:
        """Those of some agents, to change and to `put` back; `rows` is a slice for all of them."""
        return self if isinstance(rows, slice) else self.take(rows)

    def put(self, rows: Any, some: Grants) -> None:
        """Change those of some agents."""
        if some is not self:
            for field in fields(self):
                getattr(self, field.name)[rows] = getattr(some, field.name)

    def forget(self, where: Booleans) -> None:
        """Crossings that are over, or that nobody waits at any more."""
        self.order[where], self.arrival[where] = NEVER, NEVER
        self.has_stopped[where], self.waiting[where] = False, 0.0
