"""Who and what is near each agent of a world: how far ahead along its line, and how far beside."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene import SceneActor
from ...ir.surroundings import Neighbors
from ..state.world import World
from ..vehicles.poses import Poses

LONGER = 1.6
"""How much farther along a line than as the crow flies what is near may be: a half circle."""


@dataclass
class StandingObjects:
    """The objects of scenes, and where they are along the lines of agents: found once for each
    line."""

    count: int = 0
    """K, the most objects of a scene"""
    _found: dict[int, tuple[Floats, Floats]] = field(default_factory=dict)

    @classmethod
    def of(cls, world: World) -> StandingObjects:
        """Of the scenes of a world."""
        return cls(max((len(scene.objects) for scene in world.scenes), default=0))

    def places(self, world: World, agents: Integers) -> tuple[Floats, Floats]:
        """(N, K) arc length along the lines of agents, and how far left of them; NaN for none."""
        along = np.full((len(agents), self.count), math.nan)
        left = along.copy()
        for number, agent in enumerate(agents):
            objects = world.scenes[agent // world.slots].objects
            if not objects or not world.filled[agent]:
                continue
            row = int(world.track.row[agent])
            if row not in self._found:
                self._found[row] = _on_line(world, row, objects)
            found = self._found[row]
            along[number, : len(objects)], left[number, : len(objects)] = found
        return along, left


def _on_line(world: World, row: int, objects: tuple[SceneActor, ...]) -> tuple[Floats, Floats]:
    """(K,) the places of objects on one line: at its nearest node, and straight on from there."""
    lines = world.track.lines
    start = row * lines.cells
    stop = start + int(lines.last[row]) + 1
    x, y = (np.array([getattr(actor, name) for actor in objects], dtype=float) for name in "xy")
    off_x, off_y = x[:, None] - lines.x[start:stop], y[:, None] - lines.y[start:stop]
    cell = (off_x * off_x + off_y * off_y).argmin(axis=1)
    heading = lines.heading[start + cell]
    cosine, sine = np.cos(heading), np.sin(heading)
    chosen = np.arange(len(objects)), cell
    beyond = cosine * off_x[chosen] + sine * off_y[chosen]
    left = cosine * off_y[chosen] - sine * off_x[chosen]
    return lines.origin[row] + cell * lines.spacing[row] + beyond, left


class Nearby:
    """The neighbors of all agents of a world at one time; `objects` stay the same for a drive."""

    def __init__(self, world: World, poses: Poses, objects: StandingObjects) -> None:
        self._world, self._poses, self._objects = world, poses, objects

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
        heading, speed = poses.heading[others], world.motion.speed[others]
        turned = heading - line
        kinds = np.array(
            [actor.kind if actor is not None else "" for actor in world.actors], object
        )
        return {
            "there": there & np.isfinite(ahead),
            "name": world.names[others],
            "kind": kinds[others],
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
        for pair, (first, second) in enumerate(zip(agent, other, strict=True)):
            x, y = poses.x[second], poses.y[second]
            if max(abs(x - poses.x[first]), abs(y - poses.y[first])) > distance:
                continue
            row, along = int(world.track.row[first]), world.motion.along[first]
            spacing, origin = lines.spacing[row], lines.origin[row]
            last = int(lines.last[row])
            low = min(max(int((along - LONGER * distance - origin) / spacing), 0), last)
            high = min(max(int((along + LONGER * distance - origin) / spacing) + 2, low + 1), last)
            nodes = row * lines.cells + np.arange(low, max(high, low + 1))
            off_x, off_y = x - lines.x[nodes], y - lines.y[nodes]
            near = int((off_x * off_x + off_y * off_y).argmin())
            heading = lines.heading[nodes[near]]
            cosine, sine = np.cos(heading), np.sin(heading)
            beyond = cosine * off_x[near] + sine * off_y[near]
            out[0, pair] = origin + (low + near) * spacing + beyond - along
            out[1, pair] = cosine * off_y[near] - sine * off_x[near]
            out[2, pair] = heading
        return out

    def _standing(self, rows: Integers) -> dict[str, Any]:
        """The objects, (N, K)."""
        world, count = self._world, self._objects.count
        along, left = self._objects.places(world, rows)
        scenes = [world.scenes[row // world.slots].objects for row in rows]

        def column(name: str, default: Any, kind: Any = np.float64) -> Any:
            out = np.full((len(rows), count), default, dtype=kind)
            for row, objects in enumerate(scenes):
                out[row, : len(objects)] = [getattr(record, name) for record in objects]
            return out

        zero = np.zeros((len(rows), count))
        there = np.isfinite(along) & world.has_road[rows][:, None]
        return {
            "there": there,
            "name": column("name", "", object),
            "kind": column("kind", "", object),
            **{
                name: column(name, math.nan)
                for name in ("x", "y", "heading", "length", "width")
            },
            "speed": zero,
            "ahead": _around(along - world.motion.along[rows][:, None], world, rows),
            "left": left - world.motion.offset[rows][:, None],
            "pace": zero,
            "drift": zero,
            "walks": np.zeros((len(rows), count), dtype=bool),
        }  # fmt: skip


def _around(ahead: Floats, world: World, rows: Integers) -> Floats:
    """On closed lines, at most half a lap ahead or behind."""
    length = world.length[rows][:, None]
    laps = np.floor(ahead / length + 0.5) * world.closed[rows][:, None]
    return np.where(world.closed[rows][:, None], ahead - laps * length, ahead)
