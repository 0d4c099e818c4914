"""`distance(trees, ego)`, `gap(trees, trees)` in a `require`: how far apart things are placed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import AgentOrObject, PlacedBatch, RoadNumber, geometry, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats

FAR = 1e9
"""Meters between two of which there is none, or only one in a group"""


def _nearest(
    first: PlacedBatch,
    second: PlacedBatch,
    distance: Callable[[geometry.Footprints, geometry.Footprints], Floats],
) -> Floats:
    """(V, 1) the least distance of a member of one to a different member of the other."""
    import numpy as np

    both = first.present[:, :, None] & second.present[:, None, :]
    if first is second:
        both = both & ~np.eye(both.shape[1], dtype=bool)
    a = geometry.Footprints(*(part[:, :, None] for part in _parts(first)))
    b = geometry.Footprints(*(part[:, None, :] for part in _parts(second)))
    found = np.where(both, distance(a, b), FAR)
    return np.asarray(found.min(axis=(1, 2), initial=FAR)[:, None])


def _parts(placed: PlacedBatch) -> tuple[Floats, ...]:
    return placed.x, placed.y, placed.heading, placed.length, placed.width


def _middles(a: geometry.Footprints, b: geometry.Footprints) -> Floats:
    import numpy as np

    return np.hypot(a.x - b.x, a.y - b.y)


def _outlines(a: geometry.Footprints, b: geometry.Footprints) -> Floats:
    import numpy as np

    return np.maximum(geometry.distance_between(a, b), 0.0)


@dataclass(frozen=True)
class PlacedDistance(RoadNumber):
    """Distance between the centers of two things where they are placed; of groups, between the
    nearest different members."""

    name: ClassVar[str] = "distance"
    unit: ClassVar[str] = "m"
    of_groups: ClassVar[bool] = True
    first: AgentOrObject = option(help="an agent, an object or a group of them")
    second: AgentOrObject = option(help="another agent or object, or the same group")

    def values(self) -> Floats:
        return _nearest(self.first, self.second, _middles)


@dataclass(frozen=True)
class PlacedGap(RoadNumber):
    """Gap between the outlines of two things where they are placed; of groups, between the nearest
    different members."""

    name: ClassVar[str] = "gap"
    unit: ClassVar[str] = "m"
    of_groups: ClassVar[bool] = True
    first: AgentOrObject = option(help="an agent, an object or a group of them")
    second: AgentOrObject = option(help="another agent or object, or the same group")

    def values(self) -> Floats:
        return _nearest(self.first, self.second, _outlines)
