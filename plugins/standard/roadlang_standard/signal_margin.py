"""`margin(a, p, q)`: how far a road keeps inside a box."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Point, RoadOrNetwork, Signal, geometry, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Margin(Signal):
    """Distance of the center line to the edge of a box, positive inside."""

    name: ClassVar[str] = "margin"
    unit: ClassVar[str] = "m"
    cost: ClassVar[float] = 6.0
    road: RoadOrNetwork = option(help="road whose center line is measured")
    corner: Point = option(help="a corner of the box")
    opposite: Point = option(help="the corner across from it")

    def values(self) -> Floats:
        return geometry.margin(self.road.curves, self.corner, self.opposite)
