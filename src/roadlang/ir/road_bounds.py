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
    """Bounds of a road that follow from the options of its passes, in meters: a number, or (V, 1)
    for variants.

    `root`: the road that it derives from; `passes`: the greatest displacement by each pass between
    the root and the road, by the place of the pass, infinite where it is not known; `reached`: the
    least that some of them move it by somewhere.
    """

    name: str
    root: str
    passes: Mapping[str, Bound] = field(default_factory=dict)
    reached: Mapping[str, float] = field(default_factory=dict)

    @property
    def displacement(self) -> Bound:
        """Upper bound of the distance between the road and its root at any station."""
        return sum(self.passes.values(), start=0.0)

    def apart(self, other: RoadBounds) -> Bound:
        """Upper bound of the distance between two roads at any station; infinite if their roots
        differ."""
        if self.root != other.root:
            return math.inf
        return sum(self._different(other).values(), start=0.0)

    def reach(self, other: RoadBounds) -> float:
        """A distance that two roads reach at some station; 0 if their roots differ.

        The bounds of the passes are numbers or arrays of one value.
        """
        if self.root != other.root:
            return 0.0
        different = {place: _number(bound) for place, bound in self._different(other).items()}
        moved = {**self.reached, **other.reached}
        by_each = (
            moved.get(place, 0.0) - sum(v for p, v in different.items() if p != place)
            for place in different
        )
        return max(0.0, *by_each, 0.0)

    def _different(self, other: RoadBounds) -> dict[str, Bound]:
        """The displacements by passes that only one of two roads has."""
        both = {**self.passes, **other.passes}
        return {place: both[place] for place in sorted(self.passes.keys() ^ other.passes.keys())}


def _number(bound: Bound) -> float:
    return float(bound if isinstance(bound, float | int) else bound.item())
