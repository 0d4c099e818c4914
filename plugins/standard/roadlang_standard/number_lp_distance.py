"""`lp_distance(a, b, p)`: the d_p of the paper."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import LENGTH, Dimension, Number, RoadName, RoadNumber, geometry, option
from roadlang_standard.nearest import nearest_lp_distance

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


@dataclass(frozen=True)
class LpDistance(RoadNumber):
    """The L_p distance of two roads: (integral of |a - b|^p over arc length)^(1/p)."""

    name: ClassVar[str] = "lp_distance"
    cost: ClassVar[float] = 6.0
    road: RoadName = option(help="one road")
    other: RoadName = option(help="the other")
    p: Number = option(minimum=1, maximum=100, help="the power")

    @classmethod
    def dimension_of(cls, options: Mapping[str, Any]) -> Dimension:
        return LENGTH ** (1 + 1 / float(options.get("p", 1)))

    def values(self) -> Floats:
        if self.road.root == self.other.root:
            return geometry.lp_distance(self.road.curves, self.other.curves, self.p)[:, None]
        return nearest_lp_distance(self.road, self.other, self.p)
