"""`draw with waypoints`: a road through points."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Drawer, ListOf, Point, geometry, option


@dataclass(frozen=True)
class Waypoints(Drawer):
    """A cubic spline through the points."""

    name: ClassVar[str] = "waypoints"
    points: ListOf[Point] = option(at_least=2, help="points on the center line, in driving order")

    def draw(self, closed: bool) -> geometry.Curve:
        """A cubic spline by arc length; a closed road goes back to the first point."""
        return geometry.Curve.through(self.points, closed)

    def least_length(self) -> float:
        """From point to point in straight lines, less rounding."""
        return 0.999999 * math.fsum(map(math.dist, self.points, self.points[1:]))
