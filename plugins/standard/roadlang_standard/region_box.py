"""`within: box((0m, 0m), (200m, 100m))`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import OptionError, Point, Region, option

if TYPE_CHECKING:
    from roadlang.geometry import Booleans, Floats


@dataclass(frozen=True)
class BoxRegion(Region):
    """A rectangle whose sides run east and north, between two opposite corners."""

    name: ClassVar[str] = "box"
    corner: Point = option(help="a corner")
    opposite: Point = option(help="the opposite corner")

    def __post_init__(self) -> None:
        """Raises RL480 for a box without area."""
        pairs = zip(self.corner, self.opposite, strict=True)
        if any(isinstance(n, int | float) and n == m for n, m in pairs):
            raise OptionError("opposite", "leaves the box without area: it must differ from "
                "`corner` in both coordinates")  # fmt: skip

    def contains(self, points: Floats) -> Booleans:
        """The border belongs to it."""
        low = [min(pair) for pair in zip(self.corner, self.opposite, strict=True)]
        high = [max(pair) for pair in zip(self.corner, self.opposite, strict=True)]
        x, y = points[:, 0], points[:, 1]
        return (x >= low[0]) & (x <= high[0]) & (y >= low[1]) & (y <= high[1])
