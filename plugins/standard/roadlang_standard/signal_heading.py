"""`heading(a)`: where a road points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import RoadOrNetwork, Signal, option


@dataclass(frozen=True)
class Heading(Signal):
    """Heading of the centre line, counter-clockwise from east, without jumps."""

    name: ClassVar[str] = "heading"
    unit: ClassVar[str] = "rad"
    road: RoadOrNetwork = option(help="the road")
