"""The base class of positions: where an agent or object is, by another one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from .base import Kind

if TYPE_CHECKING:
    from ...geometry.arrays import Booleans, Floats, Integers


@dataclass(frozen=True, eq=False)
class Standing:
    """Where copies stand on the road of another: arrays (R, 1)."""

    start: Floats
    """arc length, meters"""
    lane: Integers
    """as in OpenDRIVE; 0 for none"""
    offset: Floats
    """left of the center line, meters, of those in no lane"""
    backward: Booleans
    """whether it faces against the road"""


class Position(Kind):
    """A position, written as a call after `at`: `ahead_of(ego, 20m)`.

    A field that names an agent or object holds a `PlacedBatch` of arrays (R, 1): where it is in the
    scene of each of R copies that are placed; of a group, the copy with the same number.
    """

    verb: ClassVar[str] = "position"
    required_methods: ClassVar[tuple[str, ...]] = ("place",)

    def place(self, length: Floats, width: Floats) -> Standing:
        """Where the copies stand, on the road of the other; `length` and `width` (R, 1) are their
        own, in meters. A lane that the road does not have is RL613."""
        raise NotImplementedError
