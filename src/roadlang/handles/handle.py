"""A place that can be dragged."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

Sort: TypeAlias = Literal["waypoint", "place", "object", "agent", "junction", "street"]


SPACING = 30.0
"""Meters from one handle of a road to the next, about."""


@dataclass(frozen=True)
class Handle:
    """A place that can be dragged, meters east and north. `number`: which of the waypoints it is;
    `station`: where it is along the root road, of a place of a road that is not drawn
    through points."""

    sort: Sort
    name: str
    x: float
    y: float
    number: int = 0
    station: float = 0.0
