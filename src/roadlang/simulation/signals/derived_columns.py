"""Recorded quantities of agents that meet nobody: they follow from others, and are computed when
they are first read."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..state import along_lines
from ..state.world import World
from ..surroundings.levels import ground_heights

KEPT = (
    "x", "y", "heading", "speed", "steering", "route_progress", "present", "along", "offset",
)  # fmt: skip
"""The quantities from which those of `DerivedColumns` follow."""


@dataclass(frozen=True)
class DerivedColumns:
    """Columns (N,) over agents without routes, whose lines do not move, on which nothing stands."""

    length: Floats
    end: Floats
    has_road: Booleans
    closed: Booleans
    backward: Booleans
    line_offset: Floats
    contacts: Floats
    red_light: Floats
    collision: Floats
    elevation: Floats

    @classmethod
    def of(cls, world: World) -> DerivedColumns:
        """Those of the agents of a world, until it has fewer."""
        return cls(
            world.length, world.end, world.has_road, world.closed, world.backward,
            world.line_offset.copy(), world.contacts.copy(), world.red_lights.copy(),
            world.collision.copy(), ground_heights(world),
        )  # fmt: skip

    def take(self, agents: Integers) -> DerivedColumns:
        """Those of some agents."""
        return DerivedColumns(*(column[agents] for column in vars(self).values()))

    def at_end(self, along: Floats, traveled: Floats) -> Booleans:
        """(T, N) who has arrived, at arc lengths, which each has traveled so far."""
        laps = self.closed if np.count_nonzero(self.closed) else None
        return along_lines.at_end(along, traveled, self.end, self.has_road, laps, self.length)

    def column(self, name: str, kept: Callable[[str], Floats]) -> Floats:
        """(T, N) a quantity that is not `KEPT`. `kept`: (T, N) one that is."""
        along = kept("along")
        if name == "station":
            return along_lines.station(along, self.length, self.backward)
        if name == "cross_track_error":
            return kept("offset") - self.line_offset
        if name == "progress":
            traveled = kept("route_progress")
            return along_lines.progress(
                along, traveled, self.length, self.has_road, self.closed,
                self.at_end(along, traveled),
            )  # fmt: skip
        constant: Floats = getattr(self, name)
        return np.broadcast_to(constant, along.shape)
