"""Where the dashes of broken lines lie along a road."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import ceil

from .lane_paint import DASH, GAP

PERIOD = DASH + GAP
"""Meters from dash to dash; where a period begins and ends, there is half a gap."""
_CUT = 0.1
"""Meters: of a road that is missing where it ends at a junction, at least."""
_SHORTEST = 1e-3


@dataclass(frozen=True, slots=True)
class DashPattern:
    """A station of the road where no dash is, and how much the pattern is compressed."""

    origin: float = 0.0
    scale: float = 1.0

    @classmethod
    def between(cls, start: float, end: float, whole: tuple[float, float]) -> DashPattern:
        """Of the part of a road from `start` to `end`, of its stations `whole`: as many dashes as
        fit, none of them cut off where the road ends at a junction."""
        if start <= whole[0] + _CUT and end >= whole[1] - _CUT:
            return UNCUT
        length = max(end - start, 1e-6)
        return cls(start, max(PERIOD * round(length / PERIOD), 1e-3) / length)

    def at(self, station: float) -> float:
        """The place in the pattern, meters."""
        return (station - self.origin) * self.scale

    def dashes(self, start: float, end: float) -> Iterator[tuple[float, float]]:
        """The stations between these two from which to which there is a dash."""
        first = ceil((self.at(start) - 0.5 * GAP - DASH) / PERIOD)
        for number in range(first, ceil(self.at(end) / PERIOD) + 1):
            low = self.origin + (number * PERIOD + 0.5 * GAP) / self.scale
            low, high = max(low, start), min(low + DASH / self.scale, end)
            if high - low > _SHORTEST:
                yield low, high


UNCUT = DashPattern()
"""Of a road that ends nowhere but in the open."""
