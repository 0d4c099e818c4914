"""Where in a network copies begin, before what is beside and across the road is counted."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..geometry.arrays import Floats, Integers

FAR_AWAY = 1e6
"""Meters that lack to what is placed by something that is not there"""
UNREACHED = 1.0
"""What is lacking where no way leads through the points of a route, or the road does not have the
lane, as if in meters"""


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
    """meters that a point is too far from every lane, or `UNREACHED`; else 0"""

    @classmethod
    def of(cls, count: int, road: int) -> Spots:
        """All at the start of a road, for now."""
        no = np.zeros(count, dtype=bool)
        zero = np.zeros(count)
        lane = np.zeros(count, np.int64)
        return cls(np.full(count, road), zero, lane, zero.copy(), no, no.copy(), zero.copy())

    def stand(
        self, row: int, road: int, start: float, lane: int, offset: float, backward: bool
    ) -> None:
        """Fill in one."""
        self.road[row], self.start[row], self.lane[row] = road, start, lane
        self.offset[row], self.backward[row] = offset, backward
        self.is_directed[row] = True
