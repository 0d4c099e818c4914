"""`clearance(a)`: how far a road keeps from itself and other roads."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import RoadOrNetwork, Signal, geometry, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


FARTHEST = 1e4
"""Meters: the clearance of a road that has nothing to keep clear of."""


@dataclass(frozen=True)
class Clearance(Signal):
    """Distance of the center line from the road's other parts and its network's other roads."""

    name: ClassVar[str] = "clearance"
    unit: ClassVar[str] = "m"
    cost: ClassVar[float] = 3000.0
    road: RoadOrNetwork = option(help="road whose distance from itself and others is measured")

    @classmethod
    def range(cls, options: Mapping[str, Any]) -> tuple[Floats | float, Floats | float]:
        return 0.0, FARTHEST

    def values(self) -> Floats:
        import numpy as np

        others = [road.curves for road in self.road.others]
        return np.minimum(geometry.clearance(self.road.curves, others), FARTHEST)
