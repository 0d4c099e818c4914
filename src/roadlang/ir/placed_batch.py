"""Where the copies of an agent or object are, in many candidates at once."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING

from .read_only import Frozen

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ..geometry.arrays import Floats


@dataclass(frozen=True, eq=False)
class PlacedBatch(Frozen):
    """Arrays (V, N): N copies in V candidates, of which some candidates may have fewer.

    Without a road `start` and `offset` are NaN and `lane` is 0. In a network `start` counts along
    one of its roads.
    """

    present: NDArray[np.bool_]
    """whether the candidate has the copy"""
    x: Floats
    """meters east"""
    y: Floats
    """meters north"""
    heading: Floats
    """radians, counter-clockwise from east"""
    length: Floats
    """meters along the heading"""
    width: Floats
    """meters across the heading"""
    start: Floats
    """arc length along the road, meters"""
    offset: Floats
    """left of the center line, meters"""
    lane: NDArray[np.int64]
    """as in OpenDRIVE; 0 for none"""
    backward: NDArray[np.bool_]
    """whether it faces against the road"""
    road: NDArray[np.int64]
    """of what is placed in a network, the number of its road there; else -1"""

    def copy(self, number: int) -> PlacedBatch:
        """The copy of that number, counted from 1: arrays (V, 1)."""
        columns = slice(number - 1, number)
        return PlacedBatch(*(getattr(self, field.name)[:, columns] for field in fields(self)))
