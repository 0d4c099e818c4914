"""The pieces of `draw with segments`: `straight(80m)`, `arc(40m, 60deg)`, clothoids."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, ClassVar

from roadlang.api import Angle, Curvature, Length, OptionError, Piece, geometry, option

MOST_TURN = math.radians(3600)


@dataclass(frozen=True)
class StraightPiece(Piece):
    """A straight line."""

    name: ClassVar[str] = "straight"
    also_called: ClassVar[tuple[str, ...]] = ("line",)
    length: Length = option(above=0, maximum=1e5, help="arc length")

    def to_segment(self, curvature: float) -> Any:
        """The piece as geometry has it, behind a piece that ends with `curvature`."""
        return geometry.Straight(self.length)

    def least_length(self) -> float:
        """Its length."""
        return self.length


@dataclass(frozen=True)
class ArcPiece(Piece):
    """A circular arc."""

    name: ClassVar[str] = "arc"
    also_called: ClassVar[tuple[str, ...]] = ("curve", "bend", "turn")
    radius: Length = option(
        above=0,
        maximum=1e6,
        help="radius of the center line",
        if_negative="the radius is positive; to turn right, make the angle negative: "
        "`arc(40m, -60deg)`",
    )
    angle: Angle = option(
        minimum=-MOST_TURN, maximum=MOST_TURN, help="angle of the turn, positive to the left"
    )

    def __post_init__(self) -> None:
        """Raises RL480 for an arc that does not turn."""
        if isinstance(self.angle, int | float) and self.angle == 0:
            raise OptionError("angle", "is 0", "for a piece that does not turn, write `straight`")

    def to_segment(self, curvature: float) -> Any:
        """The piece as geometry has it, behind a piece that ends with `curvature`."""
        return geometry.Arc(self.radius, self.angle)

    def least_length(self) -> float:
        """Its length."""
        return self.radius * abs(self.angle)


@dataclass(frozen=True)
class ClothoidPiece(Piece):
    """A clothoid: the curvature changes linearly along the arc length, up to `to`."""

    name: ClassVar[str] = "clothoid"
    also_called: ClassVar[tuple[str, ...]] = ("spiral",)
    length: Length = option(above=0, maximum=1e5, help="arc length")
    to: Curvature = option(
        minimum=-10, maximum=10, help="curvature at the end, positive to the left"
    )
    start: Curvature = option(
        None,
        minimum=-10,
        maximum=10,
        help="curvature at the start; by default that of the piece before",
    )

    def to_segment(self, curvature: float) -> Any:
        """The piece as geometry has it, behind a piece that ends with `curvature`."""
        return geometry.Clothoid(
            self.length, curvature if self.start is None else self.start, self.to
        )

    def least_length(self) -> float:
        """Its length."""
        return self.length
