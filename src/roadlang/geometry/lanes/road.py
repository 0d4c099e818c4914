"""A road: a center line with a width and lanes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Floats
from ..curves.curve import Curve
from ..curves.offsetting import offset
from ..curves.width import WidthProfile
from ..errors import GeometryError
from .cross_section import CrossSection

_SAME_WIDTH = 1e-6
"""Meters."""


@dataclass(frozen=True, eq=False)
class Road:
    """A center line, the width of its drivable lanes together along it, and its lanes.

    `lanes` equal driving lanes share the width, unless a `section` says which lanes there are;
    then `lanes` counts its drivable ones. `Road.of` takes width and count from the section. Lane
    ids are those of OpenDRIVE: -1 the first right of the middle, 1 the first left of it. Lanes on
    the right run along the road, those on the left against it. Of an odd number the extra lane is
    on the right; a single lane, -1, lies on the center line. Raises GeometryError for a width
    that is not positive, and for a section of another width or count.
    """

    curve: Curve
    width: WidthProfile
    lanes: int = 2
    section: CrossSection | None = None

    def __post_init__(self) -> None:
        if self.lanes < 1:
            raise GeometryError("a road needs at least one lane")
        self.width.require_positive()
        if self.section is not None:
            self._require_fit(self.section)

    @classmethod
    def of(cls, curve: Curve, section: CrossSection) -> Road:
        """A road with these lanes."""
        return cls(curve, section.drivable_profile(), section.lane_count, section)

    @cached_property
    def cross_section(self) -> CrossSection:
        """The lanes: those of `section`, or `lanes` equal ones."""
        if self.section is not None:
            return self.section
        return CrossSection.of_lane_count(self.lanes, self.width)

    def _require_fit(self, section: CrossSection) -> None:
        if section.lane_count != self.lanes:
            found = f"{section.lane_count} drivable lanes, not {self.lanes}"
            raise GeometryError(f"the cross-section has {found}")
        stations = section.drivable_profile().stations
        apart = np.abs(section.drivable_width(stations) - self.width.at(stations))
        if not (apart < _SAME_WIDTH).all():
            raise GeometryError(
                "the drivable lanes of the cross-section do not add up to the width"
            )

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
        return self.cross_section.ids

    def lane_width(self, lane: int, s: ArrayLike) -> Floats:
        """Meters, at each arc length. Raises GeometryError if there is no such lane."""
        return self.cross_section.lane_width(lane, s)

    def lane_offset(self, lane: int, s: ArrayLike) -> Floats:
        """Lateral offset of the middle of a lane, left positive, at each arc length.

        Raises GeometryError if there is no such lane.
        """
        return self.cross_section.offset(lane, s)

    def edges(self, stations: ArrayLike) -> tuple[Floats, Floats]:
        """The left and right edge, (S, 2) each, a point for each station, without folding."""
        left, right = self.cross_section.half_widths(stations)
        return offset(self.curve, left, stations), offset(self.curve, -right, stations)

    def lane_lines(self, stations: ArrayLike) -> tuple[Floats, ...]:
        """The lines between neighboring lanes, one fewer than lanes, from left to right, (S, 2)."""
        borders = self.cross_section.border_offsets(stations)
        return tuple(offset(self.curve, border, stations) for border in borders[1:-1])

    def outline(self, stations: ArrayLike) -> Floats:
        """A ring (2S, 2) round an open road: up its right edge, back along the left."""
        left, right = self.edges(stations)
        return np.concatenate([right, left[::-1]])
