"""The closed interval of a temporal operator."""

from __future__ import annotations

import math
from dataclasses import dataclass

from ...diagnostics import Code
from ..errors import stl_error


@dataclass(frozen=True, slots=True)
class Interval:
    """Closed [lo, hi] in the unit of the positions, 0 <= lo <= hi; `hi` may be infinite.

    Raises DiagnosticError RL305 for any other bounds.
    """

    lo: float
    hi: float = math.inf

    def __post_init__(self) -> None:
        if not 0 <= self.lo <= self.hi or math.isinf(self.lo):
            raise stl_error(Code.INVALID_INTERVAL, lo=f"{self.lo:g}", hi=f"{self.hi:g}")


UNBOUNDED = Interval(0.0)
