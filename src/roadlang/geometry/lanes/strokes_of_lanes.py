"""The lines along the borders of lanes, as figures draw them: in pixels, because a map is drawn in
many sizes. Which there are, `border_lines` says."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from .lane_paint import DASH, EDGE_INSET, GAP, BorderLine, border_lines
from .lanes import Marking

if TYPE_CHECKING:
    from .lane import Lane

_SHORTEST_DASH, _NARROWEST_LANE = 5.0, 4.0
"""Pixels: of a dash, and of a lane whose lines are drawn."""
_CURB, _THINNEST_CURB = 0.2, 0.7
"""The width of a curb in meters, and its least in pixels."""
_SHARE_OF_LANE, _THINNEST, _WIDEST = 0.035, 0.5, 2.0
"""The width of a line as a share of its lane, and its limits in pixels."""
_INSIDE_EDGE, _CLEAR_OF_EDGE = 0.09, 1.5
"""The line at the edge of a road lies inside it by this share of a lane, so that it does not touch
the edge; by at most this many pixels."""
_FROM_MIDDLE = 1.2
"""How far each line of a double one is from its middle, in widths of a line."""


@dataclass(frozen=True, slots=True)
class LaneStroke:
    """A line along one border of a road, in pixels."""

    border: int
    """its place from the left, as `CrossSection.border_offsets` has them"""
    shift: float
    """how far left of the border it runs"""
    width: float
    dashes: tuple[float, float] | None = None
    """drawn and left out, in turn, along a broken line"""
    is_curb: bool = False


def lane_strokes(
    lanes: Sequence[Lane], markings: Sequence[Marking], lane: float, pixels_per_meter: float
) -> Iterator[LaneStroke]:
    """The lines at the borders of a road with these lanes (L) and markings (L + 1), from left to
    right, whose lanes are `lane` pixels wide on average. None where lanes are too narrow to see
    lines."""
    if not are_lines_seen(lane):
        return
    width = line_width(lane)
    curb = max(_CURB * pixels_per_meter, _THINNEST_CURB)
    length = max(pixels_per_meter, _SHORTEST_DASH / DASH)
    dashes = DASH * length, GAP * length
    for line in border_lines(lanes, markings):
        if line.is_curb:
            yield LaneStroke(line.border, 0.0, curb, is_curb=True)
        else:
            shift = _shift(line, lane, width, pixels_per_meter)
            yield LaneStroke(line.border, shift, width, dashes if line.is_broken else None)


def _shift(line: BorderLine, lane: float, width: float, pixels_per_meter: float) -> float:
    """Pixels: as far as on a road, where the line is continued through junctions, or as it takes to
    see it. Lines are wider than they are painted, where they would be too thin to see."""
    seen = min(_INSIDE_EDGE * lane + width, _CLEAR_OF_EDGE)
    inset = max(EDGE_INSET * pixels_per_meter, seen)
    return line.inset * inset + line.apart * _FROM_MIDDLE * width


def are_lines_seen(lane: float) -> bool:
    """Whether lanes `lane` pixels wide are wide enough to draw lines along them."""
    return lane >= _NARROWEST_LANE


def line_width(lane: float) -> float:
    """Pixels, of the lines of a lane `lane` pixels wide."""
    return min(max(_SHARE_OF_LANE * lane, _THINNEST), _WIDEST)
