"""`length(a)`: how long a road is."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import RoadName, RoadNumber, option


@dataclass(frozen=True)
class Length(RoadNumber):
    """Arc length of the road."""

    name: ClassVar[str] = "length"
    unit: ClassVar[str] = "m"
    road: RoadName = option(help="the road")
