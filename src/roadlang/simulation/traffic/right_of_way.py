"""Right of way of all agents of a world: who may cross a junction, and where others wait.

At most one agent at a time is let go at each junction. Those let go pass in that order: each waits
before the place where an earlier one crosses, and follows it where lanes merge. The order is total
and its first waits for nobody, so nobody waits forever inside a junction.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..crossed_junctions import crossings_of
from ..crossings import STOP_GAP
from ..leaders import Leaders
from ..poses import Poses
from ..sorted_groups import sorted_groups
from ..world import World
from . import rules
from .approaches import (
    OVER_LINE,
    SIGN_DISTANCE,
    SIGN_SPEED,
    Approaches,
    braking_to_stop,
)
from .crowd import Crowd, Places
from .granting import let_go
from .grants import FIRST, NEVER, Grants
from .junction_tables import ALL_WAY_STOP
from .oncoming import Oncoming
from .pedestrians import Pedestrians
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
        sizes, self._size = sizes_of(world.bodies)
        self._places = Places.of(crossings.junctions, world.scenes, sizes)
        count, scenes = len(world.present), len(world.scenes)
        self._oncoming = Oncoming(count, world.slots)
        self._grants = Grants.none(crossings.stop.shape)
        self._last_grant = np.full((scenes, max(1, len(crossings.junctions))), -math.inf)
        self._looked = np.full(scenes, -math.inf)
        self._has_asked = np.zeros(count, dtype=bool)
        self._asking = np.zeros(count, dtype=bool)
        self._temper = np.full((2, count), MODERATE)
        self._waits = Waits(
            np.full(count, math.inf), np.full(count, -1, dtype=np.int64), np.full(count, math.inf)
        )

    def take(self, agents: Integers, scenes: Integers) -> None:
        """From now on the world has these of its agents and scenes alone."""
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

    def junctions(self, world: World, rows: Integers) -> tuple[Floats, Floats, Floats]:
        """(n,) meters from the fronts of agents to the next junction that they cross, negative on
        it, infinite for none; from there to where its connection ends; and the seconds until their
        signal is red, infinite where there is none."""
        crossings, places = self._crossings.take(rows), self._places
        each = np.arange(len(rows))
        if not crossings.junctions:
            never = np.full(len(rows), math.inf)
            return never, np.zeros(len(rows)), never.copy()
        near = Approaches.of(world, rows, (crossings, places.tables, places.lights))
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
        temper: tuple[Floats | float, Floats | float] | None = None,
    ) -> tuple[Floats, Floats, Floats]:
        """(N,) meters from the fronts of agents to where they have to stop, infinite for no need;
        the gap to who goes first where lanes merge, as if it were ahead in the lane already,
        infinite for nobody; and the speed of that one. Who asks obeys from then on. `temper`: their
        politeness and aggression, each from 0 to 1."""
        if not self._crossings.junctions and world.sweeps.is_empty:
            never = np.full(len(rows), math.inf)
            return never, never.copy(), np.zeros(len(rows))
        if temper is not None:
            self._temper[0, rows], self._temper[1, rows] = temper
        self._look(world, leaders, rows)
        waits, traveled = self._waits, world.traveled
        leader = waits.leader[rows]
        gap = waits.distance[rows] + traveled[leader] - traveled[rows]
        follows = leader >= 0
        speed = np.where(follows, world.motion.speed[leader], 0.0)
        return waits.stop[rows] - traveled[rows], np.where(follows, gap, math.inf), speed

    def _look(self, world: World, leaders: Leaders, rows: Integers) -> None:
        """Bring the scenes of some agents up to date, where that is due. Who has asked since the
        last time obeys; at first everybody is taken to."""
        scenes = sorted_groups(rows // world.slots)[0]
        scenes_to_update = scenes[world.time - self._looked[scenes] > INTERVAL - 1e-6]
        if len(scenes_to_update):
            agents = (scenes_to_update[:, None] * world.slots + np.arange(world.slots)).ravel()
            self._has_asked[agents] = self._asking[agents]
            new = np.repeat(np.isinf(self._looked[scenes_to_update]), world.slots)
            self._has_asked[agents] |= new
            self._asking[agents] = False
            self._looked[scenes_to_update] = world.time
            self._update(world, leaders, agents)
        self._asking[rows] = True

    def _update(self, world: World, leaders: Leaders, rows: Integers) -> None:
        may_cross: Booleans = np.asarray(np.isfinite(self._grants.order).any(axis=1))
        stop = self._waits.stop - world.traveled
        oncoming = self._oncoming.ahead(world, stop, leaders, may_cross, rows)
        if not self._crossings.junctions:
            self._waits.stop[rows] = (world.traveled + oncoming)[rows]
            return
        crossings, places = self._crossings.take(rows), self._places
        is_moving = world.present & ~world.halted & ~world.bodies.walks
        crowd = Crowd(
            places, world.time, crossings,
            Approaches.of(world, rows, (crossings, places.tables, places.lights)),
            self._grants.take(rows), rows // world.slots, world.motion.speed[rows],
            world.bodies.length[rows], self._size[rows], world.present[rows], is_moving[rows],
            self._has_asked[rows],
            self._temper[0, rows], self._temper[1, rows],
            leaders.gaps.reshape(-1, world.slots)[rows], oncoming[rows],
        )  # fmt: skip
        _remember(crowd)
        wanted = let_go(crowd, self._last_grant)
        self._grants.put(rows, crowd.grants)
        self._wait(crowd, wanted, world, rows)

    def _wait(self, crowd: Crowd, wanted: Booleans, world: World, rows: Integers) -> None:
        """Where agents have to stop, and whom they follow. `wanted`: (N, X) requested crossings."""
        near, held = crowd.near, crowd.held
        closed = np.where(held | near.is_over, math.inf, near.to_line - STOP_GAP)
        stop = np.minimum(closed.min(axis=1), crowd.oncoming)
        gap = np.full(len(rows), math.inf)
        leader = np.full(len(rows), -1)
        if held.any():
            meetings = crowd.meetings(held | wanted)
            stops, gaps = rules.zone_stops(meetings, near, crowd.grants, crowd.length)
            there = meetings.is_there
            np.minimum.at(stop, meetings.row[there], stops.min(axis=2)[there])
            nearest = gaps.argmin(axis=2)
            least = np.take_along_axis(gaps, nearest[:, :, None], axis=2)[:, :, 0]
            np.minimum.at(gap, meetings.row[there], least[there])
            follows = there & np.isfinite(least) & (least == gap[meetings.row])
            other = np.take_along_axis(meetings.row, nearest, axis=1)
            leader[meetings.row[follows]] = rows[other[follows]]
        traveled = world.traveled
        first = np.maximum(leader, 0)
        waits = self._waits
        waits.stop[rows] = traveled[rows] + stop
        waits.leader[rows] = leader
        waits.distance[rows] = np.where(leader >= 0, gap + traveled[rows] - traveled[first], gap)


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
    in_turn = crowd.places.tables.rule[np.maximum(crowd.crossings.junction, 0)] == ALL_WAY_STOP
    grants.arrival[stops & in_turn] = crowd.time
