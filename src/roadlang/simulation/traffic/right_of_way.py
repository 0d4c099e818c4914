"""Right of way of all agents of a world: who may cross a junction, and where others wait.

At most one agent at a time is let go at each junction. Those let go pass in that order: each waits
before the place where an earlier one crosses, and follows it where lanes merge. The order is total
and its first waits for nobody, so nobody waits forever inside a junction.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..state.world import World
from ..surroundings.crossed_junctions import crossings_of
from ..surroundings.due_scenes import due_scenes
from ..surroundings.leaders import Leaders
from ..vehicles.poses import Poses
from .approaches import Approaches
from .crowd import Crowd
from .entrants import Entrants, Ways
from .grants import Grants
from .looking import begun, looked
from .next_to_go import let_go
from .oncoming import Oncoming
from .pedestrians import Pedestrians
from .places import Places
from .remembering import INTERVAL
from .swept_paths import sizes_of
from .waiting import waits

MODERATE = 0.5
"""Politeness and aggression of who does not say, from 0 to 1."""


@dataclass(frozen=True)
class Waits:
    """Columns (N,): where agents have to stop, and whom they follow where lanes merge."""

    stop: Floats
    """`World.traveled` of the front at the stop, infinite for none"""
    leader: Integers
    """column of who goes first, -1 for none"""
    distance: Floats
    """gap to the leader, less its `traveled` and plus the own"""


class RightOfWayGrants:
    """Grants of the agents of a world, brought up to date when they are needed."""

    def __init__(self, world: World) -> None:
        self._crossings = crossings = crossings_of(world)
        self._pedestrians = Pedestrians(world, crossings)
        sizes, self._size = sizes_of(world.bodies, world.table.aside[world.table.line])
        self._places = Places.of(crossings.junctions, world.scenes, sizes)
        count, scenes = len(world.present), len(world.scenes)
        self._oncoming = Oncoming(world)
        self._grants = Grants.none(crossings.stop.shape)
        self._last_grant = np.full((scenes, max(1, len(crossings.junctions))), -math.inf)
        self._looked = np.full(scenes, -math.inf)
        self._has_asked = np.zeros(count, dtype=bool)
        self._asking = np.zeros(count, dtype=bool)
        self._temper = np.full((2, count), MODERATE)
        self._entrants: Entrants | None = None
        self._waits = Waits(
            np.full(count, math.inf), np.full(count, -1, dtype=np.int64), np.full(count, math.inf)
        )

    def take(self, agents: Integers, scenes: Integers) -> None:
        """From now on the world has these of its agents and scenes alone."""
        self._entrants = None
        self._pedestrians.take(agents)
        self._oncoming.take(agents)
        place = np.full(len(self._has_asked) + 1, -1)
        place[agents] = np.arange(len(agents))
        self._crossings, self._grants = self._crossings.take(agents), self._grants.take(agents)
        self._last_grant, self._looked = self._last_grant[scenes], self._looked[scenes]
        self._temper, self._size = self._temper[:, agents], self._size[agents]
        self._has_asked, self._asking = self._has_asked[agents], self._asking[agents]
        waits = self._waits
        self._waits = Waits(waits.stop[agents], place[waits.leader[agents]], waits.distance[agents])

    def pedestrians(self, world: World, poses: Poses, rows: Integers) -> Floats:
        """(n,) meters from the fronts of agents to where they have to stop for a pedestrian who
        steps toward their lane or waits at a crossing, infinite for nobody."""
        return self._pedestrians.ahead(world, poses, rows)

    @property
    def obeys(self) -> Booleans:
        """(N,) who asks where it has to stop, and obeys."""
        return self._has_asked

    def stops(self, world: World) -> Floats:
        """(N,) meters from the fronts of all agents to where they had to stop, when that was last
        looked at; infinite for no need."""
        return np.asarray(self._waits.stop - world.traveled)

    def junctions(self, world: World, rows: Integers) -> tuple[Floats, Floats, Floats]:
        """(n,) meters from the fronts of agents to the next junction that they cross, negative on
        it, infinite for none; from there to where its connection ends; and the seconds until their
        signal is red, infinite where there is none."""
        places = self._places
        each = np.arange(len(rows))
        if not self._crossings.junctions:
            never = np.full(len(rows), math.inf)
            return never, np.zeros(len(rows)), never.copy()
        near = Approaches.of(world, self._ways(world, rows))
        distance = np.where(near.is_over, math.inf, near.to_line)
        slot = distance.argmin(axis=1)
        distance, number = distance[each, slot], near.number[each, slot]
        there = np.isfinite(distance)
        length = np.where(there, places.tables.length[number], 0.0)
        _, left = places.lights.at(number, world.age[rows])
        return distance, length, np.where(there, left, math.inf)

    def ahead(
        self,
        world: World,
        poses: Poses,
        leaders: Leaders,
        rows: Integers,
        objects: Callable[[], Floats],
        temper: tuple[Floats | float, Floats | float] | None = None,
    ) -> tuple[Floats, Floats, Floats]:
        """(N,) meters from the fronts of agents to where they have to stop, infinite for no need;
        the gap to who goes first where lanes merge, as if it were ahead in the lane already,
        infinite for nobody; and the speed of that one. Who asks obeys from then on. `objects`: (N,)
        gaps of all agents to the objects in their ways; `temper`: their politeness and aggression,
        each from 0 to 1."""
        if not self._crossings.junctions and world.sweeps.is_empty:
            self._has_asked[rows] = True
            never = np.full(len(rows), math.inf)
            return never, never.copy(), np.zeros(len(rows))
        if temper is not None:
            self._temper[0, rows], self._temper[1, rows] = temper
        self._look(world, poses, leaders, rows, objects)
        waits, traveled = self._waits, world.traveled
        leader = waits.leader[rows]
        gap = waits.distance[rows] + traveled[leader] - traveled[rows]
        follows = leader >= 0
        speed = np.where(follows, world.motion.speed[leader], 0.0)
        return waits.stop[rows] - traveled[rows], np.where(follows, gap, math.inf), speed

    def _look(
        self, world: World, poses: Poses, leaders: Leaders, rows: Integers,
        objects: Callable[[], Floats],
    ) -> None:  # fmt: skip
        """Bring the scenes of some agents up to date, where that is due. Who has asked since the
        last time obeys; at first everybody is taken to."""
        scenes, agents = due_scenes(world, rows, self._looked, INTERVAL)
        if len(scenes):
            new = np.isinf(self._looked[scenes]).repeat(world.slots)
            self._has_asked[agents] = self._asking[agents] | new
            self._asking[agents] = False
            self._looked[scenes] = world.time
            self._update(world, poses, leaders, agents, objects())
        self._asking[rows] = True

    def _update(
        self, world: World, poses: Poses, leaders: Leaders, rows: Integers, objects: Floats
    ) -> None:
        may_cross: Booleans = np.asarray(np.isfinite(self._grants.order).any(axis=1))
        stop = np.minimum(self._waits.stop - world.traveled, objects)
        oncoming = self._oncoming.ahead(world, poses, stop, leaders, may_cross, rows)
        if not self._crossings.junctions:
            self._waits.stop[rows] = (world.traveled + oncoming)[rows]
            return
        entrants = self._entrants_of(world, rows)
        every = entrants.ways.rows
        is_moving = world.present & ~world.halted & ~world.bodies.walks
        crowd = Crowd(
            entrants, world.time, begun(world, entrants.ways), self._grants.part(every),
            world.motion.speed[every], world.present[every], is_moving[every],
            self._has_asked[every], self._temper[0, every], self._temper[1, every],
            leaders.gaps.reshape(-1, world.slots)[every], objects[every], oncoming[every],
        )  # fmt: skip
        wanted = let_go(crowd, looked(world, crowd), self._last_grant)
        self._grants.put(every, crowd.grants)
        self._wait(crowd, wanted, world)

    def _ways(self, world: World, rows: Integers) -> Ways:
        """Of some agents."""
        everyone = len(rows) == len(world.present)
        crossings = self._crossings if everyone else self._crossings.take(rows)
        places, part = self._places, slice(None) if everyone else rows
        return Ways.of(part, crossings, world.bodies, places.tables, places.lights)

    def _entrants_of(self, world: World, rows: Integers) -> Entrants:
        """The agents `rows`, all of some scenes: mostly those of the last time."""
        known = self._entrants
        if known is None or not known.holds(rows, world.bodies):
            ways = self._ways(world, rows)
            known = Entrants.of(self._places, rows, ways, world.slots, self._size)
            self._entrants = known
        return known

    def _wait(self, crowd: Crowd, wanted: Booleans, world: World) -> None:
        """Where agents have to stop, and whom they follow. `wanted`: (N, X) requested crossings."""
        stop, leader, gap = waits(crowd, wanted)
        rows, traveled, known = crowd.entrants.ways.rows, world.traveled, self._waits
        leader = np.where(leader >= 0, crowd.entrants.agents[leader], -1)
        known.stop[rows] = traveled[rows] + stop
        known.leader[rows] = leader
        follows = leader >= 0
        if np.count_nonzero(follows):
            first = np.maximum(leader, 0)
            gap = np.where(follows, gap + traveled[rows] - traveled[first], gap)
        known.distance[rows] = gap
