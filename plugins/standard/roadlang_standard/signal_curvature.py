"""`curvature(a)`: how sharply a road bends."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import RoadOrNetwork, Signal, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Curvature(Signal):
    """Curvature of the center line, left positive; of a network also that of turns at junctions."""

    name: ClassVar[str] = "curvature"
    unit: ClassVar[str] = "1/m"
    cost: ClassVar[float] = 10.0
    on_connections: ClassVar[bool] = True
    road: RoadOrNetwork = option(help="road whose center line is measured")

    def values(self) -> Floats:
        return self.road.curvature
