"""`width(a)`: how wide a road is."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import RoadOrNetwork, Signal, option


@dataclass(frozen=True)
class Width(Signal):
    """Width of the road from edge to edge."""

    name: ClassVar[str] = "width"
    unit: ClassVar[str] = "m"
    road: RoadOrNetwork = option(help="the road")
