"""Narrow places: bends in which a long vehicle covers a part of the oncoming lane.

The lines of two agents that come toward each other are compared. Where the two do not fit side by
side, the one that is there already, cannot stop any more, or arrives first goes; the other waits
before the place.
"""

from __future__ import annotations

import math

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...geometry.curves.bend_room import BRAKING
from ..state.world import World
from ..surroundings.leaders import Leaders
from ..vehicles.poses import Poses
from .approaches import braking_to_stop, seconds_for
from .meeting_ways import is_plain, meeting_places
from .narrow_places import narrow_places
from .sampled_ways import SPACING, SampledWays
from .wide_places import VIEW, WidePlaces

BEFORE = 1.0
"""Meters before such a place at which one waits."""
EAGER, EAGER_SPEED = 2.6, 8.0
"""m/s^2 and m/s: how fast both are expected to come there."""
STANDING_GAP, STANDING_SPEED = 3.0, 0.1
"""An agent slower than `STANDING_SPEED` m/s within `STANDING_GAP` meters of another one stands
because of it."""
DECIDED = 4.0
"""Seconds: who will be there sooner, and was to go first, does."""


class Oncoming:
    """Who waits for whom in narrow places. Who was to go first stays so until both have passed,
    unless it does not come."""

    def __init__(self, world: World) -> None:
        self._first = np.zeros((len(world.present), world.slots), dtype=bool)
        """(N, A) who goes before which other of its scene"""
        self._wide = WidePlaces.of(world)

    def take(self, agents: Integers) -> None:
        """From now on the world has these of its agents alone."""
        self._first = self._first[agents]

    def ahead(
        self,
        world: World,
        poses: Poses,
        stop: Floats,
        leaders: Leaders,
        on_junction: Booleans,
        due: Integers,
    ) -> Floats:
        """(N,) meters from the fronts of agents to where they have to wait for somebody who comes
        toward them, infinite for no need. `stop`: (N,) meters to where they have to stop anyway.
        Who does not get to such a place lets others go; who may cross a junction (N,), which it
        would block, goes before those that are not there yet. Only for the agents `due`, which are
        all of some scenes."""
        out = np.full(len(world.present), math.inf)
        before = self._first.copy()
        self._first[due] = False
        if not self._wide.holds(world.sweeps):
            self._wide = WidePlaces.of(world)
        found = None if world.sweeps.is_empty else _meeting(world, poses, self._wide)
        if found is None:
            return out
        first, second, enter, leave = found
        meets = np.isfinite(enter).all(axis=0) & np.tile(np.isin(first, due), 2)
        rows = np.stack([np.tile(agents, 2)[meets] for agents in (first, second)])
        enter, leave = enter[:, meets], leave[:, meets]
        inside = (enter <= -SPACING) & (leave > 0.0)
        free = _free(world, rows, stop, leaders) > enter
        comes = (inside | (free & ~world.halted[rows])) & (leave > 0.0)
        rank = np.where(inside, -2.0, np.where(on_junction[rows], -1.5, 0.0))
        rank = np.where(_cannot_pass(world, rows, leaders), math.inf, rank)
        yields = self._yields(world, rows, enter, rank, comes, before)
        waits = comes[::-1] & yields & (enter > -SPACING)
        np.minimum.at(out, rows[waits], enter[waits] - SPACING - BEFORE)
        return out

    def _yields(
        self,
        world: World,
        rows: Integers,
        enter: Floats,
        rank: Floats,
        comes: Booleans,
        before: Booleans,
    ) -> Booleans:
        """(2, P) which one of each pair lets the other go first. That is remembered. `rank`: lower
        ones go first, those of 0 by arrival."""
        speed, mates = world.motion.speed[rows], rows[::-1] % world.slots
        late = braking_to_stop(speed, enter - SPACING - BEFORE) > BRAKING
        arrival = np.where(late, 0.0, seconds_for(enter, speed, EAGER, EAGER_SPEED))
        decided = np.where(before[rows, mates] & comes, -1.0, arrival)
        rank = np.where(rank == 0.0, decided, rank)
        yields = (rank > rank[::-1]) | ((rank == rank[::-1]) & (rows > rows[::-1]))
        first = ~yields & comes & (arrival < DECIDED)
        self._first[rows[first], mates[first]] = True
        return np.asarray(yields)


def _free(world: World, rows: Integers, stop: Floats, leaders: Leaders) -> Floats:
    """(2, P) meters that each of a pair may drive until it has to stop, or is behind a third."""
    ahead = leaders.gaps.reshape(-1, world.slots)[rows]
    ahead = np.where(np.arange(world.slots) == (rows[::-1] % world.slots)[..., None], np.inf, ahead)
    return np.asarray(np.minimum(stop[rows], ahead.min(axis=2)))


def _cannot_pass(world: World, rows: Integers, leaders: Leaders) -> Booleans:
    """(2, P) which one of each pair stands before somebody who comes toward it, where the other of
    the pair could pass it: they began there, or others let them no further."""
    mates = rows[::-1] % world.slots
    gap = leaders.gaps.reshape(-1, world.slots)[rows, mates]
    close = (gap < STANDING_GAP) & (world.motion.speed[rows] < STANDING_SPEED)
    stands = np.zeros(len(world.present), dtype=bool)
    stands[rows[close]] = True
    return np.asarray(stands[rows] & ~stands[rows[::-1]] & ~np.isfinite(gap[::-1]))


def _meeting(
    world: World, poses: Poses, wide: WidePlaces
) -> tuple[Integers, Integers, Floats, Floats] | None:
    """(P,) and (P,) the agents of pairs, and what `narrow_places` gives of them; None where there
    is no such place."""
    if is_plain(world):
        return meeting_places(world, poses, wide)
    pairs = _pairs(world, poses, wide)
    found = None if pairs is None else narrow_places(*pairs)
    if pairs is None or found is None:
        return None
    ways, first, second = pairs
    return ways.agents[first], ways.agents[second], *found


def _pairs(
    world: World, poses: Poses, wide: WidePlaces
) -> tuple[SampledWays, Integers, Integers] | None:
    """The lines of agents, and the places among these of pairs that may meet where the first, or
    both, cover more than their width; None for nobody."""
    moves = world.present & world.has_road & ~world.bodies.walks
    long = (moves & wide.may_be_ahead(world)).nonzero()[0]
    if not len(long):
        return None
    lines = SampledWays.of(world, long)
    bends = lines.is_wide.any(axis=0)
    if not np.count_nonzero(bends):
        return None
    in_bend = np.zeros(len(moves), dtype=bool)
    in_bend[long[bends]] = True
    scene = in_bend.nonzero()[0] // world.slots
    others = (scene[:, None] * world.slots + np.arange(world.slots)).ravel()
    first, second = np.repeat(in_bend.nonzero()[0], world.slots), others
    once = (first < second) | ~in_bend[second]
    keep = moves[second] & (first != second) & once
    keep &= _near(world, poses, lines.take(np.flatnonzero(bends)), keep)
    if not np.count_nonzero(keep):
        return None
    first, second = first[keep], second[keep]
    agents = np.unique(np.concatenate([first, second]))
    ways = SampledWays.of(world, agents)
    return ways, np.searchsorted(agents, first), np.searchsorted(agents, second)


def _near(world: World, poses: Poses, lines: SampledWays, keep: Booleans) -> Booleans:
    """(P,) of the pairs of `lines` and all others of their scenes: who can come to the bends."""
    low, high = (
        np.stack([edge(np.where(lines.is_wide, c, fill), axis=0) for c in (lines.x, lines.y)])
        for edge, fill in ((np.min, math.inf), (np.max, -math.inf))
    )
    others = (lines.agents // world.slots)[:, None] * world.slots + np.arange(world.slots)
    place = np.stack([poses.x[others], poses.y[others]])
    away = np.maximum(low[:, :, None] - place, place - high[:, :, None])
    return np.asarray(keep & (away < VIEW).all(axis=0).ravel())
