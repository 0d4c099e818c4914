"""`margin(a, p, q)`: how far a road keeps inside a box."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Point, RoadOrNetwork, Signal, option


@dataclass(frozen=True)
class Margin(Signal):
    """Distance of the centre line to the edge of a box, positive inside."""

    name: ClassVar[str] = "margin"
    unit: ClassVar[str] = "m"
    road: RoadOrNetwork = option(help="the road")
    corner: Point = option(help="a corner of the box")
    opposite: Point = option(help="the corner across from it")
