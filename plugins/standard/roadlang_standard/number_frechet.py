"""`frechet(a, b)`: the leash between two roads."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import RoadName, RoadNumber, geometry, option

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Frechet(RoadNumber):
    """Discrete Frechet distance (Eiter and Mannila 1994)."""

    name: ClassVar[str] = "frechet"
    unit: ClassVar[str] = "m"
    cost: ClassVar[float] = 500.0
    road: RoadName = option(help="one road")
    other: RoadName = option(help="the other")

    @classmethod
    def range(cls, options: Mapping[str, Any]) -> tuple[Floats | float, Floats | float]:
        return 0.0, options["road"].apart(options["other"])

    def values(self) -> Floats:
        return geometry.frechet(self.road.curves, self.other.curves)[:, None]
