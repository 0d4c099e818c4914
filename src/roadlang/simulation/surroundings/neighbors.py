"""Who and what is near each agent of a world: how far ahead along its line, and how far beside."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.surroundings import Neighbors
from ..lines.lines import Lines
from ..state.world import World
from ..vehicles.poses import Poses
from .levels import apart_where_met, ground_heights
from .standing_objects import StandingObjects

_NODES_AT_ONCE = 8192
"""Nodes that are looked at together, so few that they fit into the caches."""
LONGER = 1.6
"""How much farther along a line than as the crow flies what is near may be: a half circle."""


class Nearby:
    """The neighbors of all agents of a world at one time; `objects` stay the same for a drive."""

    def __init__(self, world: World, poses: Poses, objects: StandingObjects) -> None:
        self._world, self._poses, self._objects = world, poses, objects

    @cached_property
    def _kinds(self) -> Any:
        actors = self._world.actors
        return np.array([actor.kind if actor is not None else "" for actor in actors], object)

    def of(self, rows: Integers, distance: float) -> Neighbors:
        """(N, K) what is within a distance of some agents, from center to center."""
        movers, objects = self._agents(rows, distance), self._standing(rows)
        columns = {name: np.concatenate([movers[name], objects[name]], axis=1) for name in movers}
        off_x = columns["x"] - self._poses.x[rows][:, None]
        off_y = columns["y"] - self._poses.y[rows][:, None]
        near = off_x * off_x + off_y * off_y <= distance * distance
        columns["there"] = columns["there"] & near
        return Neighbors(**columns)

    def _agents(self, rows: Integers, distance: float) -> dict[str, Any]:
        """The other agents, (N, A)."""
        world, poses = self._world, self._poses
        others = (rows // world.slots)[:, None] * world.slots + np.arange(world.slots)
        there = world.present[others] & (others != rows[:, None])
        there &= (world.filled & world.has_road)[rows][:, None]
        ahead, beside, line = self._along(rows, others, there, distance)
        if world.heights is not None:
            agent = np.broadcast_to(rows[:, None], others.shape).ravel()
            apart = apart_where_met(
                world, agent, ahead.ravel(), ground_heights(world)[others.ravel()]
            )
            there &= ~apart.reshape(others.shape)
        heading, speed = poses.heading[others], world.motion.speed[others]
        turned = heading - line
        return {
            "there": there & np.isfinite(ahead),
            "name": world.names[others],
            "kind": self._kinds[others],
            "x": poses.x[others],
            "y": poses.y[others],
            "heading": heading,
            "speed": speed,
            "length": world.bodies.length[others],
            "width": world.bodies.width[others],
            "ahead": _around(ahead, world, rows),
            "left": beside - world.motion.offset[rows][:, None],
            "pace": speed * np.cos(turned),
            "drift": speed * np.sin(turned),
            "walks": world.bodies.walks[others],
        }

    def _along(
        self, rows: Integers, others: Integers, there: Booleans, distance: float
    ) -> tuple[Floats, Floats, Floats]:
        """(N, A) how far ahead on the line of each agent another is, how far left of that line, and
        the heading of the line there; NaN where it is too far away."""
        world = self._world
        road = np.where(world.has_route, -1, world.road)
        sign = np.where(world.backward, -1.0, 1.0)
        together = there & (road[rows][:, None] == road[others]) & (road[rows] >= 0)[:, None]
        station, left = world.station, sign * world.motion.offset
        ahead = sign[rows][:, None] * (station[others] - station[rows][:, None])
        beside = sign[rows][:, None] * left[others]
        back = np.where((sign[rows][:, None] == sign[others]), 0.0, np.pi)
        line = world.motion.line_heading[others] + back
        ahead = np.where(together, ahead, math.nan)
        observer, place = np.nonzero(there & ~together)
        if len(observer):
            found = self._searched(rows[observer], others[observer, place], distance)
            ahead[observer, place], beside[observer, place], line[observer, place] = found
        return ahead, beside, line

    def _searched(self, agent: Integers, other: Integers, distance: float) -> Any:
        """(P,) the same for pairs, at the nearest node of the line of `agent` near it."""
        world, poses, lines = self._world, self._poses, self._world.track.lines
        out = np.full((3, len(agent)), math.nan)
        x, y = poses.x[other], poses.y[other]
        close = np.abs(x - poses.x[agent]) <= distance
        close &= np.abs(y - poses.y[agent]) <= distance
        pairs = np.flatnonzero(close)
        if not len(pairs):
            return out
        agent, x, y = agent[pairs], x[pairs], y[pairs]
        row, along = world.track.row[agent], world.motion.along[agent]
        spacing, origin = lines.spacing[row], lines.origin[row]
        last, first = lines.last[row].astype(np.int64), row * lines.cells
        low = ((along - LONGER * distance - origin) / spacing).astype(np.int64)
        low = np.minimum(np.maximum(low, 0), last)
        high = ((along + LONGER * distance - origin) / spacing).astype(np.int64) + 2
        high = np.maximum(np.minimum(np.maximum(high, low + 1), last), low + 1)
        node = _nearest_nodes(lines, (first + low, first + high), x, y)
        heading = lines.heading[node]
        cosine, sine = np.cos(heading), np.sin(heading)
        off_x, off_y = x - lines.x[node], y - lines.y[node]
        beyond = cosine * off_x + sine * off_y
        out[0, pairs] = origin + (node - first) * spacing + beyond - along
        out[1, pairs] = cosine * off_y - sine * off_x
        out[2, pairs] = heading
        return out

    def _standing(self, rows: Integers) -> dict[str, Any]:
        """The objects, (N, K)."""
        world = self._world
        along, left = self._objects.places(world, rows)
        zero = np.zeros(along.shape)
        return {
            "there": np.isfinite(along) & world.has_road[rows][:, None],
            **self._objects.columns(world, rows),
            "speed": zero,
            "ahead": _around(along - world.motion.along[rows][:, None], world, rows),
            "left": left - world.motion.offset[rows][:, None],
            "pace": zero,
            "drift": zero,
            "walks": np.zeros(along.shape, dtype=bool),
        }


def _nearest_nodes(lines: Lines, span: tuple[Integers, Integers], x: Floats, y: Floats) -> Integers:
    """(P,) numbers of the nodes, from the first of a span of them up to before the second, that are
    nearest to points."""
    begin, end = span
    out, steps = np.empty(len(x), dtype=np.int64), np.arange(int((end - begin).max()))
    count = max(1, _NODES_AT_ONCE // len(steps))
    for first in range(0, len(x), count):
        pairs = slice(first, first + count)
        # Beyond its end a shorter span repeats its last node: of equal ones the first is found.
        nodes = np.minimum(begin[pairs, None] + steps, end[pairs, None] - 1)
        off_x, off_y = x[pairs, None] - lines.x[nodes], y[pairs, None] - lines.y[nodes]
        out[pairs] = begin[pairs] + (off_x * off_x + off_y * off_y).argmin(axis=1)
    return out


def _around(ahead: Floats, world: World, rows: Integers) -> Floats:
    """On closed lines, at most half a lap ahead or behind."""
    length = world.length[rows][:, None]
    laps = np.floor(ahead / length + 0.5) * world.closed[rows][:, None]
    return np.where(world.closed[rows][:, None], ahead - laps * length, ahead)
