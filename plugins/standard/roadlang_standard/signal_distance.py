"""`distance(a, b)`: between two roads, point by point."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import RoadOrNetwork, Signal, option
from roadlang_standard.road_pairs import COMPARED, OTHER, distances

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Distance(Signal):
    """Distance between two roads: at the same station, or to the nearest point of another root."""

    name: ClassVar[str] = "distance"
    unit: ClassVar[str] = "m"
    cost: ClassVar[float] = 3.0
    road: RoadOrNetwork = option(help=COMPARED)
    other: RoadOrNetwork = option(help=OTHER)

    @classmethod
    def range(cls, options: Mapping[str, Any]) -> tuple[Floats | float, Floats | float]:
        return 0.0, options["road"].apart(options["other"])

    @classmethod
    def reached(cls, options: Mapping[str, Any]) -> float:
        return float(options["road"].reach(options["other"]))

    def values(self) -> Floats:
        return distances(self.road, self.other)
