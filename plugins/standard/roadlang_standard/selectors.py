"""How a road is chosen of a network: `route((0m, 0m), (80m, 40m))`, `road(12)`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Point, Selector, Whole, option


@dataclass(frozen=True)
class Route(Selector):
    """The shortest way along the network between the places nearest to two points."""

    name: ClassVar[str] = "route"
    start: Point = option(help="near where it begins")
    end: Point = option(help="near where it ends")


@dataclass(frozen=True)
class RoadById(Selector):
    """One road of the network, by its number."""

    name: ClassVar[str] = "road"
    id: Whole = option(minimum=0, help="the number in the picture, the scene file or the map")
