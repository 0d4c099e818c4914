"""`sup_distance(a, b)`: the greatest distance between two roads."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang_standard.road_pairs import RoadPair, distances

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class SupDistance(RoadPair):
    """Greatest distance between two roads: at the same station, or to the nearest point."""

    name: ClassVar[str] = "sup_distance"
    unit: ClassVar[str] = "m"
    cost: ClassVar[float] = 4.0

    def values(self) -> Floats:
        greatest: Floats = distances(self.road, self.other).max(axis=1, keepdims=True)
        return greatest
