"""`deviation(a, b)`: the error added along the spline."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import RoadOrNetwork, Signal, option
from roadlang_standard.road_pairs import COMPARED, offsets

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Deviation(Signal):
    """How far the road was displaced along its normal, at each station of the original."""

    name: ClassVar[str] = "deviation"
    unit: ClassVar[str] = "m"
    cost: ClassVar[float] = 2.0
    road: RoadOrNetwork = option(help=COMPARED)
    origin: RoadOrNetwork = option(help="road that it was displaced from, or is compared with")

    @classmethod
    def range(cls, options: Mapping[str, Any]) -> tuple[Floats | float, Floats | float]:
        return 0.0, options["road"].apart(options["origin"])

    @classmethod
    def reached(cls, options: Mapping[str, Any]) -> float:
        return float(options["road"].reach(options["origin"]))

    def values(self) -> Floats:
        return offsets(self.road, self.origin)
