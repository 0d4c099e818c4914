"""`sup_distance(a, b)`: the greatest distance between two roads."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import RoadName, RoadNumber, geometry, option
from roadlang_standard.nearest import nearest_distance

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


@dataclass(frozen=True)
class SupDistance(RoadNumber):
    """Greatest distance between two roads, station by station."""

    name: ClassVar[str] = "sup_distance"
    unit: ClassVar[str] = "m"
    cost: ClassVar[float] = 4.0
    road: RoadName = option(help="one road")
    other: RoadName = option(help="the other")

    @classmethod
    def range(cls, options: Mapping[str, Any]) -> tuple[Floats | float, Floats | float]:
        return 0.0, options["road"].apart(options["other"])

    def values(self) -> Floats:
        if self.road.root == self.other.root:
            return geometry.sup_distance(self.road.curves, self.other.curves)[:, None]
        greatest: Floats = nearest_distance(self.road, self.other).max(axis=1, keepdims=True)
        return greatest
