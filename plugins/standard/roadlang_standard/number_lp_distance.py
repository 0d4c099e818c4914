"""`lp_distance(a, b, p)`: the d_p of the paper."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from roadlang.api import LENGTH, Dimension, Number, RoadName, RoadNumber, option


@dataclass(frozen=True)
class LpDistance(RoadNumber):
    """The L_p distance of two roads: (integral of |a - b|^p over arc length)^(1/p)."""

    name: ClassVar[str] = "lp_distance"
    road: RoadName = option(help="one road")
    other: RoadName = option(help="the other")
    p: Number = option(minimum=1, maximum=100, help="the power")

    @classmethod
    def dimension_of(cls, options: Mapping[str, Any]) -> Dimension:
        return LENGTH ** (1 + 1 / options.get("p", 1))
