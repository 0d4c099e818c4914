"""The ways of agents ahead, sampled: where they lead, and what agents cover beside them."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..state.world import World
from ..vehicles.poses import frames_ahead
from .wide_places import VIEW, is_wide

SPACING = 2.0
"""Meters between two samples of a line."""


@dataclass(frozen=True)
class SampledWays:
    """The lines of some agents I around them, at M places: arrays (M, I)."""

    agents: Integers
    s: Floats
    """meters ahead of the middle of the agent, NaN beyond the end of its line"""
    x: Floats
    y: Floats
    cosine: Floats
    sine: Floats
    to_left: Floats
    """what the agent covers of the ground to the left of its line there"""
    to_right: Floats
    is_wide: Booleans
    """where the agent may need more than its lane"""
    height: Floats | None = None
    """None on level ground"""

    @classmethod
    def of(cls, world: World, agents: Integers) -> SampledWays:
        """Of some agents, from their rears to `VIEW` ahead."""
        half = 0.5 * world.bodies.length[agents]
        count = math.ceil((VIEW + 2.0 * float(half.max(initial=0.0))) / SPACING) + 1
        s = np.arange(count, dtype=np.float64)[:, None] * SPACING - half
        track = world.track.of_rows(agents)
        along = world.motion.along[agents] + s
        place = track.wrapped(along)
        cell, (x, y, heading, _, road_width) = frames_ahead(track, place)
        cosine, sine = np.cos(heading), np.sin(heading)
        offset, width = world.followed.offset(agents, place), 0.5 * world.bodies.width[agents]
        left, right = world.sweeps.at(agents, cell - track.first)
        over = ~world.closed[agents] & (along > world.end[agents] + half)
        # Others that are longer have more samples, which may not change what this one sees.
        over |= s > VIEW + half
        wide = is_wide(world, agents, np.maximum(left, right), road_width) & ~over
        return cls(
            agents, np.where(over, math.nan, s), x - sine * offset, y + cosine * offset,
            cosine, sine, left + width, right + width, wide,
            None if world.heights is None else world.heights.cells[cell],
        )  # fmt: skip

    def take(self, places: Integers) -> SampledWays:
        """Those of some of the agents, which may be the same."""
        columns = (self.s, self.x, self.y, self.cosine, self.sine, self.to_left, self.to_right)
        s, x, y, cosine, sine, left, right = (column[:, places] for column in columns)
        is_wide = self.is_wide[:, places]
        height = None if self.height is None else self.height[:, places]
        return SampledWays(self.agents[places], s, x, y, cosine, sine, left, right, is_wide, height)
