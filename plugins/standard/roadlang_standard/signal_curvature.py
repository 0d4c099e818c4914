"""`curvature(a)`: how sharply a road bends."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import RoadOrNetwork, Signal, option


@dataclass(frozen=True)
class Curvature(Signal):
    """Curvature of the centre line, left positive."""

    name: ClassVar[str] = "curvature"
    unit: ClassVar[str] = "1/m"
    road: RoadOrNetwork = option(help="the road")
