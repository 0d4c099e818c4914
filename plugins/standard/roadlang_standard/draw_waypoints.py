"""`draw with waypoints`: a road through points."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Drawer, Length, ListOf, OptionError, Point, Word, geometry, option


@dataclass(frozen=True)
class Waypoints(Drawer):
    """A curve through the points.

    A spline passes through every point; where a distance between points is much longer than the
    next, it keeps to the straight line. A polyline has straight lines between all points, and its
    rounded corners cut them short.
    """

    name: ClassVar[str] = "waypoints"
    also_called: ClassVar[tuple[str, ...]] = ("points", "line", "path")
    points: ListOf[Point] = option(at_least=2, help="points on the center line, in driving order")
    curve: Word = option(
        "spline",
        words=("spline", "polyline"),
        help="a cubic spline, or straight lines with rounded corners",
    )
    radius: Length = option(
        10.0,
        above=0,
        maximum=1e6,
        help="radius of the corners of a `polyline`, smaller where lines are too short for it",
    )

    def __post_init__(self) -> None:
        """Raises RL480 where the points are all the same."""
        x, y = self.points[0]
        numbers = ((n, m) for p in self.points for n, m in zip(p, (x, y), strict=True))
        if all(isinstance(n, int | float) and n == m for n, m in numbers):
            raise OptionError("points", "are all the same")

    def draw(self, closed: bool) -> geometry.Curve:
        """A closed road goes back to the first point."""
        if self.curve == "polyline":
            return geometry.filleted(self.points, self.radius, closed)
        return geometry.through_waypoints(self.points, closed)

    def least_length(self) -> float:
        """From point to point in straight lines, less rounding; rounded corners cut these short."""
        if self.curve == "polyline":
            return 0.999 * math.dist(self.points[0], self.points[-1])
        return 0.999999 * math.fsum(map(math.dist, self.points, self.points[1:]))
