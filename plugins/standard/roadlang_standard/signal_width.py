"""`width(a)`: how wide a road is."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import RoadOrNetwork, Signal, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Width(Signal):
    """Width of the road from edge to edge."""

    name: ClassVar[str] = "width"
    unit: ClassVar[str] = "m"
    cost: ClassVar[float] = 1.0
    road: RoadOrNetwork = option(help="road whose width is measured")

    def values(self) -> Floats:
        import numpy as np

        stations = len(self.road.stations)
        return np.broadcast_to(self.road.width, (self.road.width.shape[0], stations))
