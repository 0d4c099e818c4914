"""`confidence(town)`: how sure the extractor is of a road."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import RoadNumber, RoadOrNetwork, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Confidence(RoadNumber):
    """How sure the extractor is of the road, or of the whole network, 0 to 1."""

    name: ClassVar[str] = "confidence"
    cost: ClassVar[float] = 1.0
    road: RoadOrNetwork = option(help="road or network that an extractor found")

    @classmethod
    def range(cls, options: Mapping[str, Any]) -> tuple[Floats | float, Floats | float]:
        return 0.0, 1.0

    def values(self) -> Floats:
        import numpy as np

        return np.full((1, 1), self.road.confidence)
