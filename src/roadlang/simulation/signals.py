"""Drive signals of a world as it is now: what `when:` and `while:` speak of."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..geometry.arrays import Floats, Integers
from ..ir.scene import Scene
from .conditions import unsupported
from .outlines import Outlines, gaps
from .poses import Poses
from .world import World


@dataclass(frozen=True)
class Moment:
    """What can be measured of a world now: of each agent, columns (N,), and of pairs."""

    world: World
    poses: Poses
    jerk: Floats

    @property
    def time(self) -> Floats:
        """Seconds since the start."""
        return np.full(len(self.jerk), self.world.time)

    @property
    def speed(self) -> Floats:
        """m/s, along the body."""
        return self.world.motion.speed

    @property
    def acceleration(self) -> Floats:
        """m/s^2, along the body."""
        return self.world.motion.acceleration

    @property
    def yaw_rate(self) -> Floats:
        """rad/s, to the left."""
        return self.world.motion.yaw_rate

    @property
    def lateral_acceleration(self) -> Floats:
        """m/s^2: speed times yaw rate."""
        return self.speed * self.yaw_rate

    @property
    def cross_track_error(self) -> Floats:
        """m, left of the line to follow."""
        return self.world.cross_track_error

    @property
    def progress(self) -> Floats:
        """Share of the line."""
        return self.world.progress

    @property
    def station(self) -> Floats:
        """m along the road."""
        return self.world.station

    @property
    def contacts(self) -> Floats:
        """How many things were touched."""
        return self.world.contacts

    @property
    def steering(self) -> Floats:
        """Radians, to the left."""
        return np.arctan(self.world.motion.tangent)

    @property
    def heading(self) -> Floats:
        """Radians from east."""
        return self.poses.heading

    @property
    def outlines(self) -> Outlines:
        """Footprints of the agents."""
        return Outlines.moving(self.world, self.poses)


def _between_centers(first: Outlines, second: Outlines) -> Floats:
    return first.distances(second)


BETWEEN: Mapping[str, Callable[[Outlines, Outlines], Floats]] = {
    "between_centers": _between_centers,
    "between_outlines": gaps,
}
"""Measures of pairs; the others are attributes of `Moment`."""


class SignalCall:
    """One signal of a condition for R agents, which may be in different scenes.

    `calls` (R,) name the same kind, and `measures` says what of a `Moment` it is; agents are found
    by name in the scene of each. Of a group, a signal of one agent is that of its first, one of a
    pair that of its nearest.
    """

    def __init__(
        self,
        calls: list[Mapping[str, Any]],
        scenes: list[int],
        world: World,
        measures: Mapping[str, str],
    ) -> None:
        self._kind = str(calls[0]["kind"])
        if self._kind not in measures:
            raise unsupported(self._kind)
        self._measure = measures[self._kind]
        self._count = len(calls)
        self._owner = np.zeros(0, dtype=np.int64)
        self._first = self._second = self._owner
        self._still = Outlines.of(())
        options = [call.get("options", {}) for call in calls]
        if self._measure in BETWEEN:
            self._find_pairs(options, scenes, world)
        else:
            self._find_members(options, scenes, world)

    def values(self, now: Moment) -> Floats:
        """(R,) the signal now."""
        if self._measure not in BETWEEN:
            return np.asarray(getattr(now, self._measure)[self._first])
        every = now.outlines.joined(self._still)
        apart = BETWEEN[self._measure](every.take(self._first), every.take(self._second))
        least = np.full(self._count, math.inf)
        np.minimum.at(least, self._owner, apart)
        return least

    def take(self, rows: Integers, agents: Integers, count: int) -> None:
        """From now on it is about `rows` of its agents alone; of the `count` agents of the world
        there are those that are `agents`."""
        place = np.full(count, -1)
        place[agents] = np.arange(len(agents))
        if self._measure in BETWEEN:
            kept = np.isin(self._owner, rows)
            still = self._second >= count
            second = np.where(still, self._second - count + len(agents), 0)
            second[~still] = place[self._second[~still]]
            number = np.full(self._count, -1)
            number[rows] = np.arange(len(rows))
            self._owner = number[self._owner[kept]]
            self._first, self._second = place[self._first[kept]], second[kept]
        else:
            self._first = place[self._first[rows]]
        self._count = len(rows)

    def _find_members(
        self, options: list[Mapping[str, Any]], scenes: list[int], world: World
    ) -> None:
        found = []
        for one, scene in zip(options, scenes, strict=True):
            everyone = [scene * world.slots]  # a signal of no agent is the same for all
            found.append(_agents(str(one["agent"]), scene, world) if "agent" in one else everyone)
        if not all(found):
            raise unsupported(self._kind)
        self._first = np.array([agents[0] for agents in found], dtype=np.int64)

    def _find_pairs(
        self, options: list[Mapping[str, Any]], scenes: list[int], world: World
    ) -> None:
        owner, first, second = [], [], []
        still: list[Any] = []
        for row, (one, scene) in enumerate(zip(options, scenes, strict=True)):
            names = [str(one["first"]), str(one["second"])]
            moving = [_agents(name, scene, world) for name in names]
            if not any(moving):
                raise unsupported(self._kind)
            if not moving[0]:
                names.reverse()
                moving.reverse()
            others = moving[1]
            if not others:
                objects = _objects(names[1], world.scenes[scene])
                others = [len(world.present) + len(still) + i for i in range(len(objects))]
                still += objects
            pairs = [(a, b) for a in moving[0] for b in others if a != b]
            owner += [row] * len(pairs)
            first += [a for a, _ in pairs]
            second += [b for _, b in pairs]
        self._owner, self._first, self._second = (
            np.array(column, dtype=np.int64) for column in (owner, first, second)
        )
        self._still = Outlines.of(still)


def _agents(name: str, scene: int, world: World) -> list[int]:
    """The agents of a name, or of a group, by their columns."""
    agents = world.scenes[scene].agents
    first = scene * world.slots
    return [first + i for i, actor in enumerate(agents) if name in (actor.name, actor.group)]


def _objects(name: str, scene: Scene) -> list[Any]:
    return [actor for actor in scene.objects if name in (actor.name, actor.group)]
