"""Ways to select a road from a network: `route((0m, 0m), (80m, 40m))`, `road(12)`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Integer, OptionError, Point, Selector, geometry, option


@dataclass(frozen=True)
class Route(Selector):
    """The shortest path through the network between two points."""

    name: ClassVar[str] = "route"
    start: Point = option(help="a point near the start of the path")
    end: Point = option(help="a point near the end of the path")

    def __post_init__(self) -> None:
        """Raises RL480 where the path would begin where it ends."""
        pairs = zip(self.start, self.end, strict=True)
        if all(isinstance(n, int | float) and n == m for n, m in pairs):
            raise OptionError("end", "is the same point as `start`")

    def select(self, network: geometry.RoadNetwork) -> geometry.Path:
        """The way between the places of the network nearest to the points."""
        return network.route(self.start, self.end)


@dataclass(frozen=True)
class RoadById(Selector):
    """One road of the network, by its id."""

    name: ClassVar[str] = "road"
    id: Integer = option(minimum=0, help="id that the map or the extractor gave the road")

    def select(self, network: geometry.RoadNetwork) -> geometry.Path:
        """The whole of that road."""
        edge = network.edge(self.id)
        return geometry.Path(network, (geometry.Step(edge.id, 0.0, edge.length),))
