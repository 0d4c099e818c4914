"""`frechet(a, b)`: the Fréchet distance of two roads."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import geometry
from roadlang_standard.road_pairs import RoadPair

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Frechet(RoadPair):
    """Discrete Fréchet distance of the stations (Eiter and Mannila 1994)."""

    name: ClassVar[str] = "frechet"
    unit: ClassVar[str] = "m"
    cost: ClassVar[float] = 500.0

    def values(self) -> Floats:
        return geometry.frechet(self.road.curves, self.other.curves)[:, None]
