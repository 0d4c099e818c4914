"""The lanes of a road as strips: what each looks like, and the lines along its two borders."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import TYPE_CHECKING

import numpy as np

from roadlang.api import geometry

from .surface_table import surface_number

if TYPE_CHECKING:
    from roadlang.api import SurfaceName

_LOOKS_EQUAL = 0.01
"""Meters."""


class Surface(IntEnum):
    """What a strip is made of (`build/looks.gd`)."""

    MARKED = 0
    PLAIN = 1
    BUS = 2
    BIKE = 3
    PARKING = 4
    SIDEWALK = 5
    GRASS = 6


class BorderLine(IntEnum):
    """The line along a border of a strip (`build/shaders/road.gdshader`)."""

    NONE = 0
    SOLID = 1
    BROKEN = 2
    DOUBLE = 3
    CURB = 4
    EDGE = 5
    """Solid, a little inside the edge of the road."""


_SURFACES = {
    "bus": Surface.BUS,
    "bike": Surface.BIKE,
    "parking": Surface.PARKING,
    "shoulder": Surface.PLAIN,
    "sidewalk": Surface.SIDEWALK,
    "median": Surface.SIDEWALK,
    "grass": Surface.GRASS,
}
_LINES = {
    "none": BorderLine.NONE,
    "solid": BorderLine.SOLID,
    "broken": BorderLine.BROKEN,
    "double": BorderLine.DOUBLE,
    "curb": BorderLine.CURB,
}


@dataclass(frozen=True, slots=True)
class LaneStrip:
    """Lanes beside each other that look alike, between borders `first` and `last` from the left.

    Broken lines part its `lanes`; a `raised` strip is only seen, and driven through.
    """

    first: int
    last: int
    surface: Surface
    left: BorderLine
    right: BorderLine
    raised: bool
    material: int = 0
    """number in the table of surfaces, for tires and looks"""

    @property
    def lanes(self) -> int:
        """How many."""
        return self.last - self.first


def lane_strips(
    section: geometry.CrossSection, surfaces: Sequence[SurfaceName | None] = ()
) -> Iterator[LaneStrip]:
    """The strips of a road from left to right. `surfaces`: of its lanes, where any is said; raised
    lanes are always paved."""
    lanes, markings = section.lanes, section.markings
    materials = [surface_number(name) for name in surfaces] or [0] * len(lanes)
    first = 0
    for place in range(1, len(lanes) + 1):
        alike = place < len(lanes) and materials[place - 1] == materials[place]
        if alike and _go_on(lanes[place - 1], lanes[place], markings[place]):
            continue
        kind = lanes[first]
        yield LaneStrip(
            first,
            place,
            surface_of(kind),
            _line(markings, first, kind.raised),
            _line(markings, place, kind.raised),
            kind.raised,
            0 if kind.raised else materials[first],
        )
        first = place


def surface_of(lane: geometry.Lane) -> Surface:
    """Of a kind that a plugin brings: as a sidewalk if it is raised, else as a roadway."""
    default = Surface.SIDEWALK if lane.raised else Surface.MARKED
    return _SURFACES.get(lane.kind, default if lane.drivable or lane.raised else Surface.PLAIN)


def _go_on(lane: geometry.Lane, other: geometry.Lane, marking: str) -> bool:
    """Whether two neighbors are drawn as one strip of equal lanes."""
    both_marked = surface_of(lane) == surface_of(other) == Surface.MARKED
    if not both_marked or marking != "broken":
        return False
    apart = np.abs(lane.width.widths - other.width.at(lane.width.stations))
    return bool((apart < _LOOKS_EQUAL).all())


def _line(markings: tuple[str, ...], place: int, raised: bool) -> BorderLine:
    line = _LINES[markings[place]]
    if place in (0, len(markings) - 1) and line == BorderLine.SOLID:
        return BorderLine.EDGE
    # The curb lies on the raised side.
    return BorderLine.NONE if line == BorderLine.CURB and not raised else line
