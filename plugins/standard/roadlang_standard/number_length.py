"""`length(a)`: how long a road is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import RoadName, RoadNumber, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Length(RoadNumber):
    """Arc length of the road."""

    name: ClassVar[str] = "length"
    unit: ClassVar[str] = "m"
    cost: ClassVar[float] = 5.0
    road: RoadName = option(help="road whose length is measured")

    @classmethod
    def range(cls, options: Mapping[str, Any]) -> tuple[Floats | float, Floats | float]:
        return 0.0, float("inf")

    def values(self) -> Floats:
        return self.road.length
