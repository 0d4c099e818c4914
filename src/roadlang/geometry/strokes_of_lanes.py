"""The lines along the borders of lanes, as figures draw them: which, how wide and how broken.

For every figure the same rule, in pixels, because a map is drawn in many sizes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from .lanes import Marking

DASH, GAP = 3.0, 4.5
"""Meters: of a dash of a broken line, and of the gap to the next."""
_SHORTEST_DASH, _NARROWEST_LANE = 5.0, 4.0
"""Pixels: of a dash, and of a lane whose lines are drawn."""
_CURB, _THINNEST_CURB = 0.2, 0.7
"""The width of a curb in meters, and its least in pixels."""
_SHARE_OF_LANE, _THINNEST, _WIDEST = 0.035, 0.5, 2.0
"""The width of a line as a share of its lane, and its limits in pixels."""
_INSIDE_EDGE = 0.09
"""Share of a lane that the line at the edge of a road lies inside."""
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
    markings: Sequence[Marking], lane: float, pixels_per_meter: float
) -> Iterator[LaneStroke]:
    """The lines at the borders of a road with these markings (L + 1), from left to right, whose
    lanes are `lane` pixels wide on average. None where lanes are too narrow to see lines."""
    if not are_lines_seen(lane):
        return
    width, last = line_width(lane), len(markings) - 1
    curb = max(_CURB * pixels_per_meter, _THINNEST_CURB)
    length = max(pixels_per_meter, _SHORTEST_DASH / DASH)
    dashes = DASH * length, GAP * length
    for border, marking in enumerate(markings):
        inside = _INSIDE_EDGE * lane + width
        shift = -inside if border == 0 else inside if border == last else 0.0
        match marking:
            case "solid":
                yield LaneStroke(border, shift, width)
            case "broken":
                yield LaneStroke(border, shift, width, dashes)
            case "double":
                for away in (_FROM_MIDDLE * width, -_FROM_MIDDLE * width):
                    yield LaneStroke(border, shift + away, width)
            case "curb":
                yield LaneStroke(border, 0.0, curb, is_curb=True)


def are_lines_seen(lane: float) -> bool:
    """Whether lanes `lane` pixels wide are wide enough to draw lines along them."""
    return lane >= _NARROWEST_LANE


def line_width(lane: float) -> float:
    """Pixels, of the lines of a lane `lane` pixels wide."""
    return min(max(_SHARE_OF_LANE * lane, _THINNEST), _WIDEST)
