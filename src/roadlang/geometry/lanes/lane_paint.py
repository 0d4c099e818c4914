"""The lines painted along the borders of lanes: which, where, how broken. For figures, meshes and
engines the same rule, in meters."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from .lanes import Marking

if TYPE_CHECKING:
    from .lane import Lane

LINE_WIDTH = 0.14
EDGE_INSET = 0.25
"""From the edge of a road, or a curb, to the middle of the line along it."""
DOUBLE_APART = 0.13
"""From the middle of a double line to that of each of its two."""
DASH, GAP = 3.0, 6.0
"""Of a dash of a broken line, and of the gap to the next."""
PARKING_SPACE = 5.5
"""Between the lines across a strip for parked cars."""
PARKING_LINE_WIDTH = 0.8 * LINE_WIDTH


@dataclass(frozen=True, slots=True)
class BorderLine:
    """One line along a border of lanes."""

    border: int
    """its place from the left, as `CrossSection.border_offsets` has them"""
    inset: int = 0
    """1: to the left of the border by the inset of an edge line; -1: to its right; 0: on it"""
    apart: int = 0
    """1: the left one of a double line, -1: the right one, 0: alone"""
    is_broken: bool = False
    is_curb: bool = False

    @property
    def shift(self) -> float:
        """Meters that its middle lies left of the border."""
        return self.inset * EDGE_INSET + self.apart * DOUBLE_APART


def border_lines(lanes: Sequence[Lane], markings: Sequence[Marking]) -> Iterator[BorderLine]:
    """The lines at the borders of these lanes (L), whose markings (L + 1) run from left to right.

    At the edge of a road, and below a raised lane, a line lies inside; a curb is on the border.
    """
    for border, marking in enumerate(markings):
        inset = _inset(lanes, border)
        match marking:
            case "solid" | "broken":
                yield BorderLine(border, inset, is_broken=marking == "broken")
            case "double":
                for apart in (1, -1):
                    yield BorderLine(border, inset, apart)
            case "curb":
                yield BorderLine(border, is_curb=True)


def parking_lines(start: float, end: float) -> list[float]:
    """The stations between these two of the lines across a strip for parked cars: whole spaces, in
    the middle; none where not even one fits."""
    count = int((end - start) / PARKING_SPACE)
    first = start + (end - start - count * PARKING_SPACE) / 2.0
    return [first + place * PARKING_SPACE for place in range(count + 1)] if count else []


def _inset(lanes: Sequence[Lane], border: int) -> int:
    """To which side of a border its line lies."""
    if border in (0, len(lanes)):
        return -1 if border == 0 else 1
    return int(lanes[border].raised) - int(lanes[border - 1].raised)
