"""The closed interval of a temporal operator."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TypeAlias

from ...diagnostics import Code, arguments
from ..errors import stl_error


@dataclass(frozen=True, slots=True)
class Interval:
    """Closed [lo, hi] in the unit of the positions, 0 <= lo <= hi; `hi` may be infinite.

    Raises DiagnosticError RL305 for any other bounds.
    """

    lo: float
    hi: float = math.inf

    def __post_init__(self) -> None:
        for name, end in (("lo", self.lo), ("hi", self.hi)):
            arguments.number(name, end)
        if not 0 <= self.lo <= self.hi or math.isinf(self.lo):
            raise stl_error(Code.INVALID_INTERVAL, lo=f"{self.lo:g}", hi=f"{self.hi:g}")


def interval_help(
    low: float, high: float, low_text: str, high_text: str
) -> tuple[tuple[str, ...], str | None]:
    """What to write in place of invalid bounds: lines of help, and the interval if it is clear."""
    if low > high >= 0:
        meant = f"[{high_text}, {low_text}]"
        return (f"it ends before it starts: write `{meant}`",), meant
    if low < 0 <= high:
        back = "to look back, use `once`, `historically` or `since`"
        meant = f"[0, {high_text}]"
        return (f"it starts at 0 or later: write `{meant}`", back), meant
    if low < 0:
        return ("to look back, use `once`, `historically` or `since` with positive bounds",), None
    return ("the lower bound must be finite",), None


UNBOUNDED = Interval(0.0)


@dataclass(frozen=True, slots=True)
class NeighborWindow:
    """The window that holds the next sample alone, or the previous one."""


Reach: TypeAlias = Interval | NeighborWindow | None
"""Which samples a temporal operator looks at; None: all later (or earlier) ones and its own."""
