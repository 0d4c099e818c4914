"""Objects that stand in the lanes of agents."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..geometry.arrays import Floats, Integers
from .outlines import Outlines
from .world import World

BESIDE = 8.0
"""Meters from a line, as long as it is not moved: what is farther away is never in the way."""
BENT, PIECE = 0.1, 1.0
"""Radians by which a line turns beside an object, from which on the object is cut into pieces of so
many meters."""
MARGIN = 0.1
"""Meters to each side between an agent and an object that it passes."""


@dataclass(frozen=True)
class Obstacles:
    """Columns (P,) over pairs of an agent and an object near its line."""

    agent: Integers
    begin: Floats
    """arc length of the line where the object begins"""
    left: Floats
    """of its middle from the tabled line"""
    half: Floats
    """half of what it takes across the line"""

    @classmethod
    def of(cls, world: World) -> Obstacles:
        """Of all agents with a road."""
        found = []
        known: dict[int, tuple[Floats, Floats, Floats]] = {}
        for agent in np.flatnonzero(world.has_road & world.filled):
            row, objects = int(world.track.row[agent]), world.scenes[agent // world.slots].objects
            if not objects:
                continue
            if row not in known:
                known[row] = _beside(world, row, Outlines.of(objects))
            found.append((np.full(len(known[row][0]), agent), *known[row]))
        if not found:
            none = np.zeros(0)
            return cls(none.astype(np.int64), none, none, none)
        agents, begin, left, half = (np.concatenate(part) for part in zip(*found, strict=True))
        return cls(agents.astype(np.int64), begin, left, half)

    def take(self, agents: Integers, count: int) -> Obstacles:
        """Those of some of `count` agents."""
        place = np.full(count, -1)
        place[agents] = np.arange(len(agents))
        remaining = place[self.agent] >= 0
        columns = (self.begin[remaining], self.left[remaining], self.half[remaining])
        return Obstacles(place[self.agent[remaining]], *columns)

    def ahead(self, world: World) -> Floats:
        """(N,) meters from the front of each agent to the next object in its way, infinite for
        none."""
        out = np.full(len(world.present), math.inf)
        if len(self.agent):
            agent, half_width = self.agent, 0.5 * world.bodies.width
            gap = self.begin - world.motion.along[agent]
            if world.track.has_closed:
                lap = world.length[agent]
                gap = np.where(world.closed[agent], gap - np.floor(gap / lap) * lap, gap)
            gap = gap - 0.5 * world.bodies.length[agent]
            aside = np.abs(self.left - world.line_offset[agent])
            room = self.half + half_width[agent] + MARGIN
            if not world.sweeps.is_empty:
                room = room + self._swept(world)
            meets = (gap > -MARGIN) & (aside < room)
            np.minimum.at(out, agent[meets], gap[meets])
        return out

    def _swept(self, world: World) -> Floats:
        """(P,) meters beyond its width that the agent covers on the side of the object."""
        track = world.track.of_rows(self.agent)
        cell = track.cell(track.wrapped(np.maximum(self.begin, 0.0)))[0] - track.first
        left, right = world.sweeps.at(self.agent, cell)
        return np.where(self.left > world.line_offset[self.agent], left, right)


def _beside(world: World, row: int, objects: Outlines) -> tuple[Floats, Floats, Floats]:
    """Begin, middle and half of the width of the objects near one line. Where it bends beside them,
    those of their pieces."""
    whole, turned = _on_line(world, row, objects)
    bent = turned > BENT
    if not bent.any():
        return whole
    pieces, _ = _on_line(world, row, objects.take(np.flatnonzero(bent)).pieces(PIECE))
    straight, _ = _on_line(world, row, objects.take(np.flatnonzero(~bent)))
    begin, left, half = (np.concatenate(pair) for pair in zip(straight, pieces, strict=True))
    return begin, left, half


def _on_line(
    world: World, row: int, objects: Outlines
) -> tuple[tuple[Floats, Floats, Floats], Floats]:
    """Begin, middle and half of the width of those near one line, and of all objects (K,) by how
    much the line turns beside each, in radians."""
    lines = world.track.lines
    first, last = row * lines.cells, int(lines.last[row])
    cells = slice(first, first + last + 1)
    off_x = objects.x[:, None] - lines.x[cells]
    off_y = objects.y[:, None] - lines.y[cells]
    cell = (off_x * off_x + off_y * off_y).argmin(axis=1)
    heading = lines.heading[first + cell]
    cosine, sine = np.cos(heading), np.sin(heading)
    each = np.arange(len(cell))
    ahead = cosine * off_x[each, cell] + sine * off_y[each, cell]
    left = cosine * off_y[each, cell] - sine * off_x[each, cell]
    along = np.abs(objects.cosine * cosine + objects.sine * sine)
    across = np.abs(objects.sine * cosine - objects.cosine * sine)
    half = objects.half_length * across + objects.half_width * along
    deep = objects.half_length * along + objects.half_width * across
    spacing = lines.spacing[row]
    begin = lines.origin[row] + cell * spacing + ahead - deep
    near = np.abs(left) < BESIDE + half
    around = np.ceil(deep / spacing).astype(np.int64)
    ends = (np.clip(cell + side * around, 0, last) for side in (-1, 1))
    low, high = (lines.heading[first + end] for end in ends)
    return (begin[near], left[near], half[near]), np.where(near, np.abs(high - low), 0.0)
