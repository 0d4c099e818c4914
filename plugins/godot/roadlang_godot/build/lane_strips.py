"""The lanes of a road as strips: what each looks like, and the lines along its two borders."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import TYPE_CHECKING

import numpy as np

from roadlang.api import geometry
from roadlang_standard.lane_looks import LaneLook, lane_look

from .surface_table import surface_number

if TYPE_CHECKING:
    from roadlang.api import SurfaceName

_LOOKS_EQUAL = 0.01
"""Meters."""


class StripLine(IntEnum):
    """What is seen in a strip of the line along one of its borders
    (`build/shaders/road.gdshader`): half of one that lies on the border, all of one inside."""

    NONE = 0
    SOLID = 1
    BROKEN = 2
    DOUBLE = 3
    CURB = 4
    INSIDE_SOLID = 5
    INSIDE_BROKEN = 6
    INSIDE_DOUBLE = 7


@dataclass(frozen=True, slots=True)
class LaneStrip:
    """Lanes beside each other that look alike, between borders `first` and `last` from the left.

    Broken lines part its `lanes`; a `raised` strip is only seen, and driven through.
    """

    first: int
    last: int
    surface: LaneLook
    left: StripLine
    right: StripLine
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
    lines: list[list[geometry.BorderLine]] = [[] for _ in markings]
    for line in geometry.border_lines(lanes, markings):
        lines[line.border].append(line)
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
            lane_look(kind),
            _line(lines[first], -1, kind.raised),
            _line(lines[place], 1, kind.raised),
            kind.raised,
            0 if kind.raised else materials[first],
        )
        first = place


def _go_on(lane: geometry.Lane, other: geometry.Lane, marking: str) -> bool:
    """Whether two neighbors are drawn as one strip of equal lanes."""
    both_marked = lane_look(lane) == lane_look(other) == LaneLook.ROADWAY
    if not both_marked or marking != "broken":
        return False
    apart = np.abs(lane.width.widths - other.width.at(lane.width.stations))
    return bool((apart < _LOOKS_EQUAL).all())


def _line(lines: Sequence[geometry.BorderLine], side: int, raised: bool) -> StripLine:
    """What a strip on the left (1) or right (-1) of a border shows of its lines."""
    if not lines:
        return StripLine.NONE
    line = lines[0]
    if line.is_curb:  # it lies on the raised side
        return StripLine.CURB if raised else StripLine.NONE
    if line.inset == -side:
        return StripLine.NONE
    if line.apart:
        return StripLine.INSIDE_DOUBLE if line.inset else StripLine.DOUBLE
    if line.is_broken:
        return StripLine.INSIDE_BROKEN if line.inset else StripLine.BROKEN
    return StripLine.INSIDE_SOLID if line.inset else StripLine.SOLID
