"""`heading(a)`: where a road points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import RoadOrNetwork, Signal, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Heading(Signal):
    """Heading of the center line, counter-clockwise from east, without jumps."""

    name: ClassVar[str] = "heading"
    unit: ClassVar[str] = "rad"
    cost: ClassVar[float] = 8.0
    road: RoadOrNetwork = option(help="road whose center line is measured")

    def values(self) -> Floats:
        return self.road.heading
