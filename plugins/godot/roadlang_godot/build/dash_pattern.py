"""Where the dashes of broken lines lie along a road."""

from __future__ import annotations

from dataclasses import dataclass

PERIOD = 9.0
"""Meters from dash to dash (`build/shaders/road.gdshader`), where no dash begins or ends."""


@dataclass(frozen=True, slots=True)
class DashPattern:
    """A station of the road where no dash is, and how much the pattern is compressed."""

    origin: float = 0.0
    scale: float = 1.0

    def at(self, station: float) -> float:
        """The place in the pattern, meters."""
        return (station - self.origin) * self.scale


UNCUT = DashPattern()
"""Of a road that ends nowhere but in the open."""


def dashes_between(start: float, end: float) -> DashPattern:
    """As many dashes as fit, none of them cut off where a road ends at a junction."""
    length = max(end - start, 1e-6)
    return DashPattern(start, max(PERIOD * round(length / PERIOD), 1e-3) / length)
