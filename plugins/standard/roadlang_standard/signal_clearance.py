"""`clearance(a)`: how far a road keeps from itself and other roads."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import RoadOrNetwork, Signal, option


@dataclass(frozen=True)
class Clearance(Signal):
    """Free space beside the road, to its own other stretches and to other roads of its network."""

    name: ClassVar[str] = "clearance"
    unit: ClassVar[str] = "m"
    road: RoadOrNetwork = option(help="the road")
