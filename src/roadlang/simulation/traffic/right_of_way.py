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
from ..junctions.crossings import STOP_GAP
from ..state.world import World
from ..surroundings.crossed_junctions import crossings_of
from ..surroundings.leaders import Leaders
from ..surroundings.sorted_groups import sorted_groups
from ..vehicles.poses import Poses
from . import rules
from .approaches import (
    OVER_LINE,
    SIGN_DISTANCE,
    SIGN_SPEED,
    Approaches,
    braking_to_stop,
)
from .crowd import Crowd
from .entrants import Entrants, Ways
from .grants import FIRST, NEVER, Grants
from .meetings import Meetings
from .next_to_go import let_go
from .oncoming import Oncoming
from .pedestrians import Pedestrians
from .places import Places
from .swept_paths import sizes_of

INTERVAL = 0.1
"""Seconds from one look at the junctions to the next."""
WAITS_WITHIN, WAITS_SLOWER = 15.0, 1.0
"""Who is slower so close to a line waits: meters and m/s."""
MODERATE = 0.5
"""Politeness and aggression of who does not say, from 0 to 1."""
UNSTOPPABLE = 4.0
"""m/s^2: who would have to brake harder before a line, and does not obey, will cross it."""


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
        self._look(world, leaders, rows, objects)
        waits, traveled = self._waits, world.traveled
        leader = waits.leader[rows]
        gap = waits.distance[rows] + traveled[leader] - traveled[rows]
        follows = leader >= 0
        speed = np.where(follows, world.motion.speed[leader], 0.0)
        return waits.stop[rows] - traveled[rows], np.where(follows, gap, math.inf), speed

    def _look(
        self, world: World, leaders: Leaders, rows: Integers, objects: Callable[[], Floats]
    ) -> None:
        """Bring the scenes of some agents up to date, where that is due. Who has asked since the
        last time obeys; at first everybody is taken to."""
        alone = len(self._looked) == 1
        scenes = np.zeros(1, np.int64) if alone else sorted_groups(rows // world.slots)[0]
        scenes_to_update = scenes[world.time - self._looked[scenes] > INTERVAL - 1e-6]
        if len(scenes_to_update):
            agents = (scenes_to_update[:, None] * world.slots + np.arange(world.slots)).ravel()
            self._has_asked[agents] = self._asking[agents]
            new = np.isinf(self._looked[scenes_to_update]).repeat(world.slots)
            self._has_asked[agents] |= new
            self._asking[agents] = False
            self._looked[scenes_to_update] = world.time
            self._update(world, leaders, agents, objects())
        self._asking[rows] = True

    def _update(self, world: World, leaders: Leaders, rows: Integers, objects: Floats) -> None:
        may_cross: Booleans = np.asarray(np.isfinite(self._grants.order).any(axis=1))
        stop = np.minimum(self._waits.stop - world.traveled, objects)
        oncoming = self._oncoming.ahead(world, stop, leaders, may_cross, rows)
        if not self._crossings.junctions:
            self._waits.stop[rows] = (world.traveled + oncoming)[rows]
            return
        entrants = self._entrants_of(world, rows)
        every = entrants.ways.rows
        is_moving = world.present & ~world.halted & ~world.bodies.walks
        crowd = Crowd(
            entrants, world.time, Approaches.of(world, entrants.ways), self._grants.part(every),
            world.motion.speed[every], world.present[every], is_moving[every],
            self._has_asked[every], self._temper[0, every], self._temper[1, every],
            leaders.gaps.reshape(-1, world.slots)[every], objects[every], oncoming[every],
        )  # fmt: skip
        _remember(crowd)
        wanted = let_go(crowd, self._last_grant)
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
        near, held, entrants = crowd.near, crowd.held, crowd.entrants
        closed = np.where(held | near.is_over, math.inf, near.to_line - STOP_GAP)
        stop = np.minimum(closed.min(axis=1), crowd.oncoming)
        gap = np.full(len(stop), math.inf)
        leader = np.full(len(stop), -1)
        if np.count_nonzero(held):
            meetings = entrants.meetings(held | wanted)
            found = None
            if meetings.has_conflicts:
                found = rules.zone_stops(meetings, near, crowd.grants, entrants.length)
            if found is not None:
                stops, gaps = found
                there, (row, _) = meetings.is_there, meetings.there
                np.minimum.at(stop, row, stops.min(axis=2)[there])
                if meetings.has_merges:
                    _follow(meetings, gaps, gap, leader)
        rows, traveled = entrants.ways.rows, world.traveled
        leader = np.where(leader >= 0, entrants.agents[leader], -1)
        waits = self._waits
        waits.stop[rows] = traveled[rows] + stop
        waits.leader[rows] = leader
        follows = leader >= 0
        if np.count_nonzero(follows):
            first = np.maximum(leader, 0)
            gap = np.where(follows, gap + traveled[rows] - traveled[first], gap)
        waits.distance[rows] = gap


def _follow(meetings: Meetings, gaps: Floats, gap: Floats, leader: Integers) -> None:
    """Fill in whom each of the agents (N,) follows where lanes merge, and the gap to that one.
    `gaps`: (G, P, P) of all that it might follow."""
    there = meetings.is_there
    least = gaps.min(axis=2)
    np.minimum.at(gap, meetings.row[there], least[there])
    follows = there & np.isfinite(least) & (least == gap[meetings.row])
    group, place = follows.nonzero()
    other = meetings.row[group, gaps[group, place].argmin(axis=1)]
    leader[meetings.row[group, place]] = other


def _remember(crowd: Crowd) -> None:
    """Forget what is over; take back what signals forbid; note who goes without asking, and who
    waits."""
    grants, near = crowd.grants, crowd.near
    grants.forget(near.is_behind | ~crowd.present[:, None])
    obeys, speed, to_line = crowd.obeys[:, None], crowd.speed[:, None], near.to_line
    ahead = ~near.is_behind & crowd.is_moving[:, None]
    grants.order[near.must_stop & obeys] = NEVER
    grants.order[crowd.held & ~obeys & (to_line >= 0.0) & (speed < SIGN_SPEED)] = NEVER
    runs = ~obeys & (to_line >= 0.0) & (braking_to_stop(speed, to_line) > UNSTOPPABLE)
    grants.order[ahead & runs] = FIRST
    inside = ahead & ~crowd.held & (to_line < -OVER_LINE)
    grants.order[inside] = np.where(obeys, crowd.time, FIRST)[inside.nonzero()[0], 0]
    close = ahead & (to_line > -OVER_LINE) & (to_line < WAITS_WITHIN) & (speed < WAITS_SLOWER)
    grants.waiting[:] = np.where(close, grants.waiting + INTERVAL, 0.0)
    stops = close & (to_line < SIGN_DISTANCE) & (speed < SIGN_SPEED) & ~grants.has_stopped
    grants.has_stopped |= stops
    grants.arrival[stops & crowd.entrants.in_turn] = crowd.time
