"""Where in a network copies begin, before what is beside and across the road is counted."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

from ...geometry.arrays import Floats, Integers


class NoPlace(IntEnum):
    """Why something has no place at all, however far it were moved."""

    HAS_ONE = 0
    NO_WAY = 1
    """no way leads through the points of its route"""
    NO_LANE = 2
    """its road does not have the lane"""
    NO_OTHER = 3
    """what it is placed by is not there"""


_VIOLATION = 1.0
"""How much a thing without a place violates the requirement that it has one: the search for scenes
counts that beside meters, but no distance says it."""


def shortfall(lacking: Floats, no_place: Integers) -> Floats:
    """How much a place violates the requirement to be one, 0 for none, any shape: `lacking` meters,
    or what counts where there is `no_place`."""
    return np.maximum(lacking, np.where(no_place != NoPlace.HAS_ONE, _VIOLATION, 0.0))


@dataclass(frozen=True, eq=False)
class Spots:
    """Arrays (R,) that are filled in row by row."""

    road: Integers
    """number of the road in the network"""
    start: Floats
    """arc length along the road"""
    lane: Integers
    """0 for none"""
    offset: Floats
    """left of the center line, meters, of what is in no lane"""
    backward: NDArray[np.bool_]
    is_directed: NDArray[np.bool_]
    """whether `backward` counts; else it faces as its lane runs"""
    lacking: Floats
    """meters that a point is too far from every lane; else 0"""
    no_place: Integers
    """see `NoPlace`"""

    @classmethod
    def of(cls, count: int, road: int) -> Spots:
        """All at the start of a road, for now."""
        no = np.zeros(count, dtype=bool)
        zero = np.zeros(count)
        lane = np.zeros(count, np.int64)
        found = np.full(count, NoPlace.HAS_ONE, np.int64)
        return cls(np.full(count, road), zero, lane, zero.copy(), no, no.copy(), zero.copy(), found)

    def stand(
        self, row: int, road: int, start: float, lane: int, offset: float, backward: bool
    ) -> None:
        """Fill in one."""
        self.road[row], self.start[row], self.lane[row] = road, start, lane
        self.offset[row], self.backward[row] = offset, backward
        self.is_directed[row] = True
