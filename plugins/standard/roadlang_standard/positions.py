"""Positions by another agent or object: `ahead_of(ego, 20m)`, `behind(ego, 15m)`,
`beside(ego, left)`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import AgentOrObject, Length, Position, Standing, Word, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


def _along(other: Any, length: Floats, gap: Floats | float, ahead: bool) -> Standing:
    """In the lane of the other, `gap` meters between the two bumpers."""
    import numpy as np

    away = gap + (other.length + length) / 2
    forward = np.where(other.backward, -1.0, 1.0) * (1.0 if ahead else -1.0)
    return Standing(other.start + forward * away, other.lane, other.offset, other.backward)


@dataclass(frozen=True)
class AheadOf(Position):
    """In front of an agent or object, in its lane."""

    name: ClassVar[str] = "ahead_of"
    other: AgentOrObject = option(help="agent or object on a road")
    distance: Length = option(minimum=0, help="from its front to the rear of what is placed")

    def place(self, length: Floats, width: Floats) -> Standing:
        """Ahead in the direction that the other faces."""
        return _along(self.other, length, self.distance, ahead=True)


@dataclass(frozen=True)
class Behind(Position):
    """Behind an agent or object, in its lane."""

    name: ClassVar[str] = "behind"
    other: AgentOrObject = option(help="agent or object on a road")
    distance: Length = option(minimum=0, help="from its rear to the front of what is placed")

    def place(self, length: Floats, width: Floats) -> Standing:
        """Behind in the direction that the other faces."""
        return _along(self.other, length, self.distance, ahead=False)


@dataclass(frozen=True)
class Beside(Position):
    """Next to an agent or object: in the next lane, or where it is in no lane, side by side."""

    name: ClassVar[str] = "beside"
    other: AgentOrObject = option(help="agent or object on a road")
    side: Word = option(words=("left", "right"), help="as seen by the other", example="left")
    gap: Length = option(1.0, minimum=0, help="between the two where the other is in no lane")

    def place(self, length: Floats, width: Floats) -> Standing:
        """At the same arc length; `lane` counts on over the middle, which has no number."""
        import numpy as np

        left = np.asarray(self.side == "left") != self.other.backward
        step = np.where(left, 1, -1)
        lane = self.other.lane + step
        lane = np.where(lane == 0, step, lane)
        away = (self.other.width + width) / 2 + self.gap
        offset = self.other.offset + np.where(left, away, -away)
        is_in_lane = self.other.lane != 0
        lane = np.where(is_in_lane, lane, 0)
        return Standing(self.other.start, lane, offset, self.other.backward)
