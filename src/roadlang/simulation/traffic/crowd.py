"""The agents of the scenes whose junctions are looked at, as they are now."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from .approaches import Approaches
from .entrants import Entrants
from .grants import Grants


@dataclass(frozen=True)
class Crowd:
    """Columns (N,) of agents, arrays (N, X) of their crossings, (N, A) of others in the scene."""

    entrants: Entrants
    time: float
    near: Approaches
    grants: Grants
    """changed by whoever lets agents go"""
    speed: Floats
    present: Booleans
    """else it has left"""
    is_moving: Booleans
    obeys: Booleans
    politeness: Floats
    aggression: Floats
    gaps: Floats
    """(N, A) along the line to each other of the scene"""
    objects: Floats
    """meters to the next object in the way of each, infinite for none"""
    oncoming: Floats
    """meters to where one waits for who comes toward it in a narrow place, infinite for no need"""

    @property
    def held(self) -> Booleans:
        """(N, X) which crossings agents may cross."""
        return np.isfinite(self.grants.order)

    @cached_property
    def ahead(self) -> tuple[Integers, Floats]:
        """(N,) who is next ahead in the lane of each, and the gap to it."""
        slots = self.gaps.shape[1]
        first, each = self.gaps.argmin(axis=1), self.entrants.each
        return each // slots * slots + first, self.gaps[each, first]

    def of_mates(self, values: Floats) -> Floats:
        """(N, A) a column of the others of the scene of each."""
        slots = self.gaps.shape[1]
        return np.asarray(values.reshape(-1, slots).repeat(slots, axis=0))
