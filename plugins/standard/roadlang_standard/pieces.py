"""The pieces of `draw with segments`: `straight(80m)`, `arc(40m, 60deg)`, clothoids."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from roadlang.api import Angle, Curvature, Length, Piece, geometry, option


@dataclass(frozen=True)
class Straight(Piece):
    """Go straight on."""

    name: ClassVar[str] = "straight"
    length: Length = option(above=0, maximum=1e5, help="how far")

    def laid(self, curvature: float) -> Any:
        """The piece as geometry has it, behind a piece that ends with `curvature`."""
        return geometry.Straight(self.length)


@dataclass(frozen=True)
class Arc(Piece):
    """Turn along a circle."""

    name: ClassVar[str] = "arc"
    radius: Length = option(above=0, maximum=1e6, help="of the center line")
    angle: Angle = option(minimum=-62.84, maximum=62.84, help="how far to turn; left is positive")

    def laid(self, curvature: float) -> Any:
        """The piece as geometry has it, behind a piece that ends with `curvature`."""
        return geometry.Arc(self.radius, self.angle)


@dataclass(frozen=True)
class Clothoid(Piece):
    """Change the curvature steadily, from what it is, or from `start`, to `to`."""

    name: ClassVar[str] = "clothoid"
    length: Length = option(above=0, maximum=1e5, help="how far")
    to: Curvature = option(minimum=-10, maximum=10, help="curvature at the end; left is positive")
    start: Curvature = option(
        None, minimum=-10, maximum=10, help="curvature at the start; the last piece's if not given"
    )

    def laid(self, curvature: float) -> Any:
        """The piece as geometry has it, behind a piece that ends with `curvature`."""
        return geometry.Clothoid(
            self.length, curvature if self.start is None else self.start, self.to
        )
