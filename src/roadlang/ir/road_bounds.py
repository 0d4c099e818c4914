"""What is known of a road before any geometry: how far its passes can have moved it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Bound: TypeAlias = float | NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class RoadBounds:
    """A road by the options of its passes. Bounds are in meters: a number, or (V, 1) of variants.

    `root`: the road that it derives from; `passes`: the greatest displacement by each pass between
    the root and the road, by the place of the pass, infinite where it is not known.
    """

    name: str
    root: str
    passes: Mapping[str, Bound] = field(default_factory=dict)

    @property
    def displacement(self) -> Bound:
        """How far the road can be from its root, at any station."""
        return sum(self.passes.values(), start=0.0)

    def apart(self, other: RoadBounds) -> Bound:
        """How far two roads can be from each other at any station; infinite of different roots."""
        if self.root != other.root:
            return math.inf
        both = {**self.passes, **other.passes}
        different = sorted(self.passes.keys() ^ other.passes.keys())
        return sum((both[place] for place in different), start=0.0)
