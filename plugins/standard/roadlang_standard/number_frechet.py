"""`frechet(a, b)`: the leash between two roads."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import RoadName, RoadNumber, option


@dataclass(frozen=True)
class Frechet(RoadNumber):
    """Discrete Frechet distance (Eiter and Mannila 1994)."""

    name: ClassVar[str] = "frechet"
    unit: ClassVar[str] = "m"
    road: RoadName = option(help="one road")
    other: RoadName = option(help="the other")
