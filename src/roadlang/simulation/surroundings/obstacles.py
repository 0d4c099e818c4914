"""Objects that stand in the lanes of agents."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..lines.lines import Lines
from ..state.world import World
from ..vehicles.poses import Poses
from .levels import are_on_level_of_line, ground_heights, on_level_of_line
from .outlines import Outlines

BESIDE = 8.0
"""Meters from a line, as long as it is not moved: what is farther away is never in the way."""
BENT, PIECE = 0.1, 1.0
"""Radians by which a line turns beside an object, from which on the object is cut into pieces of so
many meters."""
LATE = 2.5
"""m/s^2: who would have to brake harder before an object sees that it is off its line."""
_MOST_IN_A_ROW = 20
MARGIN = 0.1
"""Meters to each side between an agent and an object that it passes."""

Places = tuple[Floats, Floats, Floats, Floats]
"""Begin, middle, half of the width and end of objects."""


@dataclass(frozen=True)
class Obstacles:
    """Columns (P,) over pairs of an agent and an object near its line."""

    agent: Integers
    begin: Floats
    """arc length of the line where the object begins"""
    left: Floats
    """of its middle from the reference line"""
    half: Floats
    """half of what it takes across the line"""
    end: Floats
    """arc length of the line where it ends"""

    @classmethod
    def of(cls, world: World) -> Obstacles:
        """Of all agents with a road."""
        found = []
        known: dict[int, Places] = {}
        for agent in np.flatnonzero(world.has_road & world.filled):
            row, objects = int(world.track.row[agent]), world.scenes[agent // world.slots].objects
            if not objects:
                continue
            if row not in known and world.heights is not None:
                here = on_level_of_line(world, row, objects)
                objects = tuple(one for one, is_here in zip(objects, here, strict=True) if is_here)
            if row not in known:
                known[row] = things_beside(world.track.lines, row, Outlines.of(objects))
            found.append((np.full(len(known[row][0]), agent), *known[row]))
        return cls._joined(found)

    @classmethod
    def _joined(cls, found: Sequence[tuple[Any, ...]]) -> Obstacles:
        if not found:
            none = np.zeros(0)
            return cls(none.astype(np.int64), none, none, none, none)
        agents, *places = (np.concatenate(part) for part in zip(*found, strict=True))
        return cls(agents.astype(np.int64), *places)

    def with_agents(self, world: World, poses: Poses, standing: Booleans) -> Obstacles:
        """And those agents (N,) that are `standing`, in the ways of others."""
        found = [(self.agent, self.begin, self.left, self.half, self.end)]
        outlines, heights = Outlines.moving(world, poses), ground_heights(world)
        scenes = np.unique(np.flatnonzero(standing) // world.slots)
        known: dict[tuple[int, bytes], Places] = {}
        for agent in (scenes[:, None] * world.slots + np.arange(world.slots)).ravel().tolist():
            if not (world.has_road[agent] and world.present[agent]):
                continue
            begin, row = agent - agent % world.slots, int(world.track.row[agent])
            others = begin + np.flatnonzero(standing[begin : begin + world.slots])
            others = others[others != agent]
            if world.heights is not None:
                at = poses.x[others], poses.y[others]
                others = others[are_on_level_of_line(world, row, at, heights[others])]
            key = row, others.tobytes()
            if len(others) and key not in known:
                known[key] = things_beside(world.track.lines, row, outlines.take(others))
            if key in known:
                found.append((np.full(len(known[key][0]), agent), *known[key]))
        return self._joined(found)

    def take(self, agents: Integers, count: int) -> Obstacles:
        """Those of some of `count` agents."""
        place = np.full(count, -1)
        place[agents] = np.arange(len(agents))
        remaining = place[self.agent] >= 0
        columns = (self.begin, self.left, self.half, self.end)
        return Obstacles(place[self.agent[remaining]], *(column[remaining] for column in columns))

    def ahead(self, world: World, line: Floats | None = None) -> Floats:
        """(N,) meters from the front of each agent to the next object in its way, infinite for
        none; in the way of lines that are `line` (N,) left of the reference lines, by default of
        those that agents follow."""
        out = np.full(len(world.present), math.inf)
        if len(self.agent):
            on = self._line(world) if line is None else line[self.agent]
            gap, meets = self._in_the_way(world, on)
            np.minimum.at(out, self.agent[meets], gap[meets])
        return out

    def row_ahead(self, world: World, line: Floats, space: float) -> tuple[Floats, Floats, Floats]:
        """(N,) of the next object in the way of lines that are `line` (N,) left of the reference
        lines, and of those behind it with less than an agent and `space` meters between: how far
        from the front of the agent they end, and how far left of the reference line their left and
        right sides are; NaN for none."""
        count, agent = len(world.present), self.agent
        end, left, right = (np.full(count, value) for value in (-math.inf, -math.inf, math.inf))
        if len(agent):
            gap, meets = self._in_the_way(world, line[agent])
            last = gap + self.end - self.begin
            first = np.full(count, math.inf)
            np.minimum.at(first, agent[meets], gap[meets])
            between = world.bodies.length[agent] + space
            row = meets & (gap == first[agent])
            for _ in range(_MOST_IN_A_ROW):
                np.maximum.at(end, agent[row], last[row])
                more = meets & ~row & (gap < end[agent] + between)
                if not more.any():
                    break
                row |= more
            np.maximum.at(left, agent[row], (self.left + self.half)[row])
            np.minimum.at(right, agent[row], (self.left - self.half)[row])
        known = np.isfinite(end)
        nothing = np.full(count, math.nan)
        end, left, right = (np.where(known, part, nothing) for part in (end, left, right))
        return end, left, right

    def _in_the_way(self, world: World, line: Floats) -> tuple[Floats, Booleans]:
        """(P,) gaps from the fronts of agents, and which objects are in the way ahead of who
        follows lines (P,)."""
        agent, half_width = self.agent, 0.5 * world.bodies.width
        gap = self.begin - world.motion.along[agent]
        if world.track.has_closed:
            lap = world.length[agent]
            gap = np.where(world.closed[agent], gap - np.floor(gap / lap) * lap, gap)
        gap = gap - 0.5 * world.bodies.length[agent]
        aside = np.abs(self.left - line)
        room = self.half + half_width[agent] + MARGIN
        if not world.sweeps.is_empty:
            room = room + np.maximum(self._swept(world), self._drift(world, gap))
        return gap, (gap > -MARGIN) & (aside < room)

    def _line(self, world: World) -> Floats:
        """(P,) the lines of the agents beside the objects, left of the reference lines."""
        return world.followed.offset(self.agent, self.begin)

    def _drift(self, world: World, gap: Floats) -> Floats:
        """(P,) meters by which the front of a long agent is off its line toward an object before
        which it can hardly stop any more; of others, 0."""
        agent, speed = self.agent, world.motion.speed[self.agent]
        front = world.cross_track_error + 0.5 * world.bodies.length * world.motion.sine
        left = np.where(self.left > self._line(world), front[agent], -front[agent])
        late = (world.sweeps.table[agent] > 0) & (gap * 2.0 * LATE < speed * speed)
        return np.where(late, np.maximum(left, 0.0), 0.0)

    def _swept(self, world: World) -> Floats:
        """(P,) meters beyond its width that the agent covers on the side of the object."""
        track = world.track.of_rows(self.agent)
        cell = track.cell(track.wrapped(np.maximum(self.begin, 0.0)))[0] - track.first
        left, right = world.sweeps.at(self.agent, cell)
        return np.where(self.left > self._line(world), left, right)


def things_beside(lines: Lines, row: int, objects: Outlines) -> Places:
    """Begin, middle, half of the width and end of the objects near one line, each time that it
    passes them. Where it bends there, those of their pieces."""
    number, cell = _passes(lines, row, objects)
    places, turned = _at(lines, row, objects.take(number), cell)
    bent = np.unique(number[turned > BENT])
    if not len(bent):
        return places
    pieces = objects.take(bent).pieces(PIECE)
    which, there = _passes(lines, row, pieces)
    parts, _ = _at(lines, row, pieces.take(which), there)
    whole = ~np.isin(number, bent)
    begin, left, half, end = (
        np.concatenate([one[whole], two]) for one, two in zip(places, parts, strict=True)
    )
    return begin, left, half, end


def _passes(lines: Lines, row: int, objects: Outlines) -> tuple[Integers, Integers]:
    """Numbers of the objects near one line, and the cells where it is nearest to them: one for each
    time that it comes by."""
    first, last = row * lines.cells, int(lines.last[row])
    cells = slice(first, first + last + 1)
    off_x = objects.x[:, None] - lines.x[cells]
    off_y = objects.y[:, None] - lines.y[cells]
    square = off_x * off_x + off_y * off_y
    beside = BESIDE + objects.half_length + objects.half_width
    nearer = np.diff(square, axis=1, prepend=math.inf) < 0.0
    farther = np.diff(square, axis=1, append=math.inf) >= 0.0
    number, cell = np.nonzero(nearer & farther & (square < (beside * beside)[:, None]))
    return number, cell


def _at(lines: Lines, row: int, objects: Outlines, cell: Integers) -> tuple[Places, Floats]:
    """Begin, middle, half of the width and end of objects (P,), seen from cells of one line, and by
    how much that turns beside each, in radians."""
    first, last = row * lines.cells, int(lines.last[row])
    off_x, off_y = objects.x - lines.x[first + cell], objects.y - lines.y[first + cell]
    heading = lines.heading[first + cell]
    cosine, sine = np.cos(heading), np.sin(heading)
    ahead, left = cosine * off_x + sine * off_y, cosine * off_y - sine * off_x
    along = np.abs(objects.cosine * cosine + objects.sine * sine)
    across = np.abs(objects.sine * cosine - objects.cosine * sine)
    half = objects.half_length * across + objects.half_width * along
    deep = objects.half_length * along + objects.half_width * across
    spacing = lines.spacing[row]
    begin = lines.origin[row] + cell * spacing + ahead - deep
    around = np.ceil(deep / spacing).astype(np.int64)
    ends = (np.clip(cell + side * around, 0, last) for side in (-1, 1))
    low, high = (lines.heading[first + end] for end in ends)
    return (begin, left, half, begin + 2.0 * deep), np.abs(high - low)
