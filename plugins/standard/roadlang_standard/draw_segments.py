"""`draw with segments`: a road built from pieces."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Angle, Drawer, ListOf, Piece, Point, geometry, option


@dataclass(frozen=True)
class Segments(Drawer):
    """Join straights, arcs and clothoids, each starting where the previous one ends."""

    name: ClassVar[str] = "segments"
    pieces: ListOf[Piece] = option(
        at_least=1, help="list of `straight(80m)`, `arc(40m, 60deg)`, `clothoid(30m, to: 0.02/m)`"
    )
    start: Point = option((0.0, 0.0), help="position of the start")
    heading: Angle = option(0.0, help="heading at the start, counter-clockwise from east")

    def draw(self, closed: bool) -> geometry.Curve:
        """Exact arcs and clothoids, sampled half a meter apart."""
        return geometry.chain(self._segments(), self.start, self.heading, spacing=0.5).curve(closed)

    def least_length(self) -> float:
        """That of the pieces, less what sampling them half a meter apart may lose."""
        return 0.999 * math.fsum(piece.least_length() for piece in self.pieces)

    def _segments(self) -> list[geometry.Straight | geometry.Arc | geometry.Clothoid]:
        """The pieces as geometry has them; a clothoid begins with the curvature before it."""
        segments: list[geometry.Straight | geometry.Arc | geometry.Clothoid] = []
        curvature = 0.0
        for piece in self.pieces:
            segments.append(piece.to_segment(curvature))
            curvature = segments[-1].curvatures[1]
        return segments
