"""What roads are made of or covered by: all along, and on stretches of some lanes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

SurfaceName = Literal["asphalt", "wet", "snow", "ice", "gravel", "turf"]
SURFACE_NAMES: tuple[SurfaceName, ...] = get_args(SurfaceName)
"""Of all surfaces, always in the same order."""


@dataclass(frozen=True, slots=True)
class SurfacePatch:
    """A stretch of a road of another surface, over the whole width of its lanes."""

    surface: SurfaceName
    """what it is made of or covered by"""
    start: float
    """arc length along the road, meters"""
    end: float
    """arc length where it ends, meters"""
    lanes: tuple[int, ...] = ()
    """ids of the lanes that have it; empty: all"""
