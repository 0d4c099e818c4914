"""Contacts between agents, and of agents with what stands still: found between two samples too.

Footprints are rectangles. Between two samples they move at a constant velocity, so that the time of
the first contact has a formula, and nothing passes through anything however fast it is.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...geometry.areas.levels import are_apart
from ...geometry.arrays import Floats, Integers, inverse_index
from ..state.world import World
from ..vehicles.motion import Motion, Track
from ..vehicles.poses import Poses, poses_of
from .close_pairs import ClosePairs
from .first_contacts import first_contact, overlapping
from .levels import ground_heights, standing_heights
from .outlines import Outlines


@dataclass(frozen=True)
class Contact:
    """The first contact of `agent` (a column of the world) with another agent or an object."""

    time: float
    agent: int
    other: int
    """column of the other agent, -1 for an object"""
    name: str
    """of the other"""
    speed: float
    """relative speed, m/s"""


class ContactDetector:
    """Watches the agents of a world, from one sample to the next.

    An agent that touches something stands still from then on. Pedestrians touch only vehicles. An
    agent that has left touches nothing, and none touches what is on another level. Two that overlap
    where the scene puts them (`overlap: true`) never touch.
    """

    def __init__(self, world: World) -> None:
        self._objects = Outlines.of([actor for scene in world.scenes for actor in scene.objects])
        self._names = [actor.name for scene in world.scenes for actor in scene.objects]
        radius = np.hypot(self._objects.half_length, self._objects.half_width)
        self._object_radius = radius
        self._standing = None if world.heights is None else standing_heights(world.scenes)
        self._radius = 0.5 * np.hypot(world.bodies.length, world.bodies.width)
        self._before: Poses | tuple[Motion, Track] | None = None
        """where agents were, or what that can be computed of"""
        self._places: Floats | None = None
        """(2, N) the same, nearly"""
        pairs, self._near = self._apart(world, *_pairs(world))
        self._pairs = ClosePairs(pairs, self._radius)
        self._next_check = np.zeros(len(self._near[0]))
        self._traveled = np.zeros(len(world.present))

    def _apart(
        self, world: World, pairs: tuple[Integers, Integers], near: tuple[Integers, Integers]
    ) -> tuple[tuple[Integers, Integers], tuple[Integers, Integers]]:
        """The pairs that do not overlap at the start."""
        moving, (first, second), (agent, thing) = (
            Outlines.moving(world, world.poses), pairs, near,
        )  # fmt: skip
        clear = ~overlapping(moving, first, moving, second)
        free = ~overlapping(moving, agent, self._objects, thing)
        if self._standing is not None:
            height = ground_heights(world)
            clear |= are_apart(height[first], height[second])
            free |= are_apart(height[agent], self._standing[thing])
        return (first[clear], second[clear]), (agent[free], thing[free])

    @property
    def is_idle(self) -> bool:
        """Whether nobody can touch anything."""
        return not len(self._pairs.first) and not len(self._near[0])

    def can_be_quiet(self) -> tuple[Floats, tuple[Integers, Integers], Floats] | None:
        """What has to be known to tell steps in which nobody touches anything: (2, N) where agents
        were, nearly; the pairs that may touch, and the radii of agents (N,). None where that is
        not told."""
        if self._places is None or not self._pairs.can_be_quiet:
            return None
        return self._places, (self._pairs.first, self._pairs.second), self._radius

    def was_quiet(self, world: World, places: Floats, ways: Sequence[float]) -> None:
        """It is certain that nobody has touched anything since the last call of this or of `watch`:
        agents are at `places`, (2, N), nearly, and in each of some steps nobody has gone farther
        than so many meters."""
        self._places = places
        for way in ways:
            self._pairs.gone(way)
        self._before = world.motion.copied(), world.track

    def watch(self, world: World, poses: Poses, seconds: float) -> list[Contact]:
        """Contacts since the last call, `seconds` ago; those agents are halted in the world."""
        if self.is_idle:
            return []
        before = self._poses_before or poses
        self._seen_at(poses)
        shift_x, shift_y = poses.x - before.x, poses.y - before.y
        square = shift_x * shift_x + shift_y * shift_y
        found = self._of_agents(world, poses, (shift_x, shift_y, square))
        if len(self._near[0]):
            self._traveled += np.sqrt(square)
            found += self._of_objects(world, poses, (shift_x, shift_y))
        return self._settled(found, world, seconds) if found else []

    def seen(self, poses: Poses) -> None:
        """Agents were moved to where they touched something."""
        before = self._poses_before
        if before is not None:
            back_x, back_y = poses.x - before.x, poses.y - before.y
            self._pairs.put(back_x * back_x + back_y * back_y)
        self._seen_at(poses)

    def restart(self, agents: Integers, poses: Poses) -> None:
        """Some agents are back at the start; `poses`: of all, now."""
        if self.is_idle:
            return
        back = np.zeros(len(self._traveled), dtype=bool)
        back[agents] = True
        self._traveled[agents] = 0.0
        self._next_check[back[self._near[0]]] = 0.0
        self._pairs.restart(agents)
        self._seen_at(poses)

    def take(self, agents: Integers, count: int) -> None:
        """From now on the world has these of its `count` agents alone."""
        place = inverse_index(agents, count)
        self._pairs.take(agents, count)
        remaining = place[self._near[0]] >= 0
        self._near = (place[self._near[0][remaining]], self._near[1][remaining])
        self._next_check = self._next_check[remaining]
        self._radius, self._traveled = self._radius[agents], self._traveled[agents]
        before, self._places = self._poses_before, None
        self._before = None if before is None else before.take(agents)

    @property
    def _poses_before(self) -> Poses | None:
        """Where agents were when that was last looked at."""
        known = self._before
        return poses_of(*known) if isinstance(known, tuple) else known

    def _seen_at(self, poses: Poses) -> None:
        self._before = poses
        # With objects it has to be known exactly how far agents have gone.
        self._places = None if len(self._near[0]) else np.array((poses.x, poses.y))

    def _of_agents(
        self, world: World, poses: Poses, shift: tuple[Floats, Floats, Floats]
    ) -> list[Any]:
        first, second = self._pairs.first, self._pairs.second
        if not len(first):
            return []
        close = self._pairs.met(poses, shift[2], world.present, world.halted)
        if len(close) and world.heights is not None:
            height = ground_heights(world)
            close = close[~are_apart(height[first[close]], height[second[close]])]
        if not len(close):
            return []
        agent, partner = first[close], second[close]
        outlines = Outlines.moving(world, poses)
        relative = (shift[0][agent] - shift[0][partner], shift[1][agent] - shift[1][partner])
        share = first_contact(outlines.take(agent), outlines.take(partner), relative)
        length = np.hypot(*relative)
        return [
            (float(share[i]), int(agent[i]), int(partner[i]), -1, float(length[i]))
            for i in np.flatnonzero(share <= 1.0)
        ]

    def _of_objects(self, world: World, poses: Poses, shift: tuple[Floats, Floats]) -> list[Any]:
        """An agent that is far from an object need not be looked at until it has gone that far."""
        agent, objects = self._near
        pending = (self._traveled[agent] >= self._next_check).nonzero()[0]
        if len(pending):
            pending = pending[~world.halted[agent[pending]] & world.present[agent[pending]]]
        if not len(pending):
            return []
        checked, object_ = agent[pending], objects[pending]
        away = np.hypot(
            poses.x[checked] - self._objects.x[object_], poses.y[checked] - self._objects.y[object_]
        )
        moved = np.hypot(shift[0][checked], shift[1][checked])
        free = away - self._radius[checked] - self._object_radius[object_]
        self._next_check[pending] = self._traveled[checked] + free
        close = free <= moved
        if self._standing is not None:
            close &= ~are_apart(ground_heights(world)[checked], self._standing[object_])
        if not np.count_nonzero(close):
            return []
        checked, object_ = checked[close], object_[close]
        relative = (shift[0][checked], shift[1][checked])
        outlines = Outlines.moving(world, poses).take(checked)
        share = first_contact(outlines, self._objects.take(object_), relative)
        length = np.hypot(*relative)
        return [
            (float(share[i]), int(checked[i]), -1, int(object_[i]), float(length[i]))
            for i in np.flatnonzero(share <= 1.0)
        ]

    def _settled(self, found: list[Any], world: World, seconds: float) -> list[Contact]:
        """The contacts in the order of time; who has touched something goes no further."""
        out: list[Contact] = []
        stopped: dict[int, float] = {}
        for share, first, second, object_, length in sorted(found):
            both = [agent for agent in (first, second) if agent >= 0]
            if any(share > stopped.get(agent, math.inf) for agent in both):
                continue
            moment = world.time - (1.0 - share) * seconds
            speed = length / seconds if seconds > 0.0 else 0.0
            names = [
                _name(world, second) if second >= 0 else self._names[object_],
                _name(world, first),
            ]
            for agent, partner, name in zip(both, [second, first], names, strict=False):
                out.append(Contact(moment, agent, partner, name, speed))
                world.contacts[agent] += 1.0
                world.collision[agent] = max(world.collision[agent], speed)
                stopped.setdefault(agent, share)
        for agent, share in stopped.items():
            world.halt(agent, (1.0 - share) * seconds)
        return out


def _pairs(world: World) -> tuple[tuple[Integers, Integers], tuple[Integers, Integers]]:
    """Pairs of agents that can touch each other, and of agents and objects."""
    base = 0
    none = np.zeros(0, dtype=np.int64)
    first, second, agent, object_ = [none], [none], [none], [none]
    for scene, record in enumerate(world.scenes):
        if len(record.agents) < 2 and not record.objects:
            continue
        agents = scene * world.slots + np.arange(len(record.agents))
        vehicles = agents[~world.bodies.walks[agents]]
        row, column = np.triu_indices(len(agents), 1)
        touch = ~(world.bodies.walks[agents[row]] & world.bodies.walks[agents[column]])
        first.append(agents[row[touch]])
        second.append(agents[column[touch]])
        count = len(record.objects)
        agent.append(np.repeat(vehicles, count))
        object_.append(base + np.tile(np.arange(count), len(vehicles)))
        base += count
    joined = [np.concatenate(part).astype(np.int64) for part in (first, second, agent, object_)]
    return (joined[0], joined[1]), (joined[2], joined[3])


def _name(world: World, agent: int) -> str:
    actor = world.actors[agent]
    return actor.name if actor is not None else ""
