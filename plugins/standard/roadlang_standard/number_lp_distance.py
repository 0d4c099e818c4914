"""`lp_distance(a, b, p)`: the d_p of the paper."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import LENGTH, Dimension, Number, geometry, option
from roadlang_standard.road_pairs import RoadPair, distances

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class LpDistance(RoadPair):
    """The L_p distance of two roads: (integral of |a - b|^p over arc length)^(1/p)."""

    name: ClassVar[str] = "lp_distance"
    cost: ClassVar[float] = 6.0
    p: Number = option(minimum=1, maximum=100, help="exponent p")

    @classmethod
    def dimension_of(cls, options: Mapping[str, Any]) -> Dimension:
        return LENGTH ** (1 + 1 / float(options.get("p", 1)))

    @classmethod
    def range(cls, options: Mapping[str, Any]) -> tuple[Floats | float, Floats | float]:
        return 0.0, float("inf")

    def values(self) -> Floats:
        gaps = distances(self.road, self.other)
        return geometry.lp_norm(gaps, geometry.quadrature(self.road.curves), self.p)[:, None]
