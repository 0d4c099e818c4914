"""A road: a center line with a width and lanes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .arrays import Floats
from .curve import Curve
from .errors import GeometryError
from .lanes import lane_ids
from .offsetting import offset
from .width import WidthProfile


@dataclass(frozen=True, eq=False)
class Road:
    """A center line, the width from edge to edge along it, and `lanes` of equal width.

    Lane ids are those of OpenDRIVE: -1 the first right of the middle, 1 the first left of it. Lanes
    on the right run along the road, those on the left against it. Of an odd number the extra lane
    is on the right; a single lane, -1, lies on the center line.
    """

    curve: Curve
    width: WidthProfile
    lanes: int = 2

    def __post_init__(self) -> None:
        if self.lanes < 1:
            raise GeometryError("a road needs at least one lane")

    @property
    def closed(self) -> bool:
        """Whether the road ends where it begins."""
        return self.curve.closed

    @property
    def length(self) -> float:
        """Arc length in meters."""
        return self.curve.length

    @property
    def lane_ids(self) -> tuple[int, ...]:
        """From the left edge to the right."""
        return lane_ids(self.lanes)

    def lane_width(self, s: ArrayLike) -> Floats:
        """Meters, at each arc length."""
        return self.width.at(s) / self.lanes

    def lane_offset(self, lane: int, s: ArrayLike) -> Floats:
        """Lateral offset of the middle of a lane, left positive, at each arc length."""
        if lane not in self.lane_ids:
            known = ", ".join(str(i) for i in self.lane_ids)
            raise GeometryError(f"the road has no lane {lane}; its lanes are {known}")
        place = self.lane_ids.index(lane)
        return self.width.at(s) * (0.5 - (place + 0.5) / self.lanes)

    def edges(self, stations: ArrayLike) -> tuple[Floats, Floats]:
        """The left and right edge, (S, 2) each, a point for each station, without folding."""
        half = self.width.at(stations) / 2.0
        return offset(self.curve, half, stations), offset(self.curve, -half, stations)

    def lane_lines(self, stations: ArrayLike) -> tuple[Floats, ...]:
        """The lines between neighboring lanes, one fewer than lanes, from left to right, (S, 2)."""
        width = self.width.at(stations)
        shares = 0.5 - np.arange(1, self.lanes) / self.lanes
        return tuple(offset(self.curve, width * share, stations) for share in shares)

    def outline(self, stations: ArrayLike) -> Floats:
        """A ring (2S, 2) round an open road: up its right edge, back along the left."""
        left, right = self.edges(stations)
        return np.concatenate([right, left[::-1]])
