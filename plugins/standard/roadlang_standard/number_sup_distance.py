"""`sup_distance(a, b)`: the greatest distance between two roads."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import RoadName, RoadNumber, option


@dataclass(frozen=True)
class SupDistance(RoadNumber):
    """Greatest distance between two roads, station by station."""

    name: ClassVar[str] = "sup_distance"
    unit: ClassVar[str] = "m"
    road: RoadName = option(help="one road")
    other: RoadName = option(help="the other")
