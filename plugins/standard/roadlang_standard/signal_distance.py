"""`distance(a, b)`: between two roads, point by point."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import RoadOrNetwork, Signal, option


@dataclass(frozen=True)
class Distance(Signal):
    """Distance between two roads: at the same station, or to the nearest point of another root."""

    name: ClassVar[str] = "distance"
    unit: ClassVar[str] = "m"
    road: RoadOrNetwork = option(help="one road")
    other: RoadOrNetwork = option(help="the other")
