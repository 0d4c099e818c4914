"""`perturb with shift`: move to the side and stay there."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Length, Perturber, geometry, option

if TYPE_CHECKING:
    from roadlang.api import BatchRandom, RoadBatch
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Shift(Perturber):
    """Move the road to the side from `at` on, over `length`, as a lane change does."""

    name: ClassVar[str] = "shift"
    also_called: ClassVar[tuple[str, ...]] = ("translate", "offset", "lateral_shift")
    is_random: ClassVar[bool] = False
    at: Length = option(help="arc length at which the move begins")
    offset: Length = option(help="displacement after the move, left positive")
    length: Length = option(above=0, help="arc length of the move")

    def displacements(self, roads: RoadBatch, random: BatchRandom) -> Floats:
        """offset * (10 u^3 - 15 u^4 + 6 u^5) for u in [0, 1], the minimum-jerk profile of Flash
        and Hogan (1985): position, heading and curvature join smoothly at both ends."""
        import numpy as np

        if roads.closed:
            raise geometry.GeometryError(
                "a shift needs an open road: a closed one would not meet itself; use `bump`"
            )
        u = np.clip((roads.stations - np.asarray(self.at)) / self.length, 0.0, 1.0)
        return np.atleast_2d(self.offset * u * u * u * (10.0 - u * (15.0 - 6.0 * u)))

    def displacement_bound(self) -> Floats | float:
        return abs(self.offset)

    def displacement_reached(self, length: float, closed: bool, gap: float) -> float:
        """The offset, if the move ends on the road: its last station shows it."""
        return 0.0 if closed or self.at + self.length > length else abs(float(self.offset))

    def shortest_feature(self, length: float, closed: bool) -> Floats | float:
        """A wave of which the move is half."""
        return 2.0 * self.length
