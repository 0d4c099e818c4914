"""`perturb with bump`: one swerve."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Length, Perturber, option

if TYPE_CHECKING:
    from roadlang.api import BatchRandom, RoadBatch
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Bump(Perturber):
    """Displace the road locally, as a smooth bump."""

    name: ClassVar[str] = "bump"
    is_random: ClassVar[bool] = False
    at: Length = option(help="arc length of the middle")
    height: Length = option(help="displacement in the middle, left positive")
    length: Length = option(above=0, help="arc length of the bump")

    def displacements(self, roads: RoadBatch, random: BatchRandom) -> Floats:
        """height * (1 - x^2)^3 for x in [-1, 1]: position, heading and curvature join smoothly."""
        import numpy as np

        away = roads.stations - np.asarray(self.at)
        if roads.period is not None:
            away = np.mod(away + roads.period / 2, roads.period) - roads.period / 2
        x = np.clip(2.0 * away / self.length, -1.0, 1.0)
        return np.atleast_2d(self.height * (1.0 - x * x) ** 3)

    def displacement_bound(self) -> Floats | float:
        return abs(self.height)

    def displacement_reached(self, length: float, closed: bool, gap: float) -> float:
        """The height, less what lies between two stations, if the middle is on the road."""
        if not (closed or 0.0 <= self.at <= length):
            return 0.0
        x = min(gap / self.length, 1.0)
        return float(abs(self.height) * (1.0 - x * x) ** 3)

    def shortest_feature(self, length: float, closed: bool) -> Floats | float:
        """The bump itself."""
        return self.length
