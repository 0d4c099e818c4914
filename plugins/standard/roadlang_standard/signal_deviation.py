"""`deviation(a, b)`: the error added along the spline."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import RoadOrNetwork, Signal, option


@dataclass(frozen=True)
class Deviation(Signal):
    """How far the road was displaced along its normal, at each station of the original."""

    name: ClassVar[str] = "deviation"
    unit: ClassVar[str] = "m"
    road: RoadOrNetwork = option(help="the displaced road")
    origin: RoadOrNetwork = option(help="what it came from")
