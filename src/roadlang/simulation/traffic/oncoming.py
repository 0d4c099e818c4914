"""Narrow places: bends in which a long vehicle covers a part of the oncoming lane.

The lines of two agents that come toward each other are compared. Where the two do not fit side by
side, the one that is there already, cannot stop any more, or arrives first goes; the other waits
before the place.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...geometry.levels import are_apart
from ..state.world import World
from ..surroundings.leaders import Leaders
from ..vehicles.poses import frames_ahead
from .approaches import braking_to_stop, seconds_for
from .wide_places import MARGIN, VIEW, WidePlaces, is_wide

SPACING = 2.0
"""Meters between two samples of a line."""
COARSE = 3
"""Of so many samples, one is looked at first."""
OPPOSED = -0.5
"""Cosine of the angle between the lines of two that come toward each other, at most."""
WIDEST = 8.0
"""Meters: lines farther apart have room for two."""
BEFORE = 1.0
"""Meters before such a place at which one waits."""
EAGER, EAGER_SPEED = 2.6, 8.0
"""m/s^2 and m/s: how fast both are expected to come there."""
UNSTOPPABLE = 3.0
"""m/s^2: who would have to brake harder goes first."""
STANDING_GAP, STANDING_SPEED = 3.0, 0.1
"""Meters and m/s: who is slower so close before another stands there because of it."""
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
        pairs = None if world.sweeps.is_empty else _pairs(world, self._wide)
        if pairs is None:
            return out
        pairs = _close(*pairs)
        found = _places(*pairs)
        if found is None:
            return out
        enter, leave = found
        meets = np.isfinite(enter).all(axis=0) & np.tile(np.isin(pairs[0].agents[pairs[1]], due), 2)
        rows = np.stack([np.tile(pairs[0].agents[place], 2)[meets] for place in pairs[1:]])
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
        late = braking_to_stop(speed, enter - SPACING - BEFORE) > UNSTOPPABLE
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


@dataclass(frozen=True)
class _Samples:
    """The lines of some agents I around them, at M places: arrays (M, I)."""

    agents: Integers
    s: Floats
    """meters ahead of the middle of the agent, NaN beyond the end of its line"""
    x: Floats
    y: Floats
    cosine: Floats
    sine: Floats
    to_left: Floats
    """what the agent covers of the ground to the left of its line there"""
    to_right: Floats
    is_wide: Booleans
    """where the agent may need more than its lane"""
    height: Floats | None = None
    """None on level ground"""

    @classmethod
    def of(cls, world: World, agents: Integers) -> _Samples:
        """Of some agents, from their rears to `VIEW` ahead."""
        half = 0.5 * world.bodies.length[agents]
        count = math.ceil((VIEW + 2.0 * float(half.max(initial=0.0))) / SPACING) + 1
        s = np.arange(count, dtype=np.float64)[:, None] * SPACING - half
        track = world.track.of_rows(agents)
        along = world.motion.along[agents] + s
        place = track.wrapped(along)
        cell, (x, y, heading, _, road_width) = frames_ahead(track, place)
        cosine, sine = np.cos(heading), np.sin(heading)
        offset, width = world.followed.offset(agents, place), 0.5 * world.bodies.width[agents]
        left, right = world.sweeps.at(agents, cell - track.first)
        over = ~world.closed[agents] & (along > world.end[agents] + half)
        # Others that are longer have more samples, which may not change what this one sees.
        over |= s > VIEW + half
        wide = is_wide(world, agents, np.maximum(left, right), road_width) & ~over
        return cls(
            agents, np.where(over, math.nan, s), x - sine * offset, y + cosine * offset,
            cosine, sine, left + width, right + width, wide,
            None if world.heights is None else world.heights.cells[cell],
        )  # fmt: skip

    def take(self, places: Integers) -> _Samples:
        """Those of some of the agents, which may be the same."""
        columns = (self.s, self.x, self.y, self.cosine, self.sine, self.to_left, self.to_right)
        s, x, y, cosine, sine, left, right = (column[:, places] for column in columns)
        is_wide = self.is_wide[:, places]
        height = None if self.height is None else self.height[:, places]
        return _Samples(self.agents[places], s, x, y, cosine, sine, left, right, is_wide, height)


def _pairs(world: World, wide: WidePlaces) -> tuple[_Samples, Integers, Integers] | None:
    """The lines of agents, and the places among these of pairs that may meet where the first, or
    both, cover more than their width; None for nobody."""
    moves = world.present & world.has_road & ~world.bodies.walks
    long = (moves & wide.may_be_ahead(world)).nonzero()[0]
    if not len(long):
        return None
    lines = _Samples.of(world, long)
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
    keep &= _near(world, lines.take(np.flatnonzero(bends)), keep)
    if not np.count_nonzero(keep):
        return None
    first, second = first[keep], second[keep]
    agents = np.unique(np.concatenate([first, second]))
    return (
        _Samples.of(world, agents), np.searchsorted(agents, first), np.searchsorted(agents, second)
    )  # fmt: skip


def _near(world: World, lines: _Samples, keep: Booleans) -> Booleans:
    """(P,) of the pairs of `lines` and all others of their scenes: who can come to the bends."""
    low, high = (
        np.stack([edge(np.where(lines.is_wide, c, fill), axis=0) for c in (lines.x, lines.y)])
        for edge, fill in ((np.min, math.inf), (np.max, -math.inf))
    )
    poses = world.poses
    others = (lines.agents // world.slots)[:, None] * world.slots + np.arange(world.slots)
    place = np.stack([poses.x[others], poses.y[others]])
    away = np.maximum(low[:, :, None] - place, place - high[:, :, None])
    return np.asarray(keep & (away < VIEW).all(axis=0).ravel())


def _close(
    lines: _Samples, first: Integers, second: Integers
) -> tuple[_Samples, Integers, Integers]:
    """The pairs whose lines come close to each other somewhere."""
    x, y = lines.x[::COARSE], lines.y[::COARSE]
    dx = x[None, :, second] - x[:, None, first]
    dy = y[None, :, second] - y[:, None, first]
    near = WIDEST + COARSE * SPACING
    close = (dx * dx + dy * dy < near * near).any(axis=(0, 1))
    return lines, first[close], second[close]


def _places(lines: _Samples, first: Integers, second: Integers) -> tuple[Floats, Floats] | None:
    """(2, 2 P) meters from the front of each of a pair to the first sample in a place where both do
    not fit side by side, infinite for none, and until its rear has left it: in the next such place
    of the first, and in all others together. None where all pairs fit everywhere."""
    one, two = lines.take(first), lines.take(second)
    dx, dy = two.x[None] - one.x[:, None], two.y[None] - one.y[:, None]
    square = dx * dx + dy * dy
    opposed = one.cosine[:, None] * two.cosine[None] + one.sine[:, None] * two.sine[None] < OPPOSED
    near = opposed & (square < WIDEST * WIDEST)
    left = one.cosine[:, None] * dy - one.sine[:, None] * dx
    seen = -two.cosine[None] * dy + two.sine[None] * dx
    room = np.where(left > 0.0, one.to_left[:, None], one.to_right[:, None])
    room = room + np.where(seen > 0.0, two.to_left[None], two.to_right[None]) + MARGIN
    meets = near & (square < room * room) & np.isfinite(one.s)[:, None] & np.isfinite(two.s)[None]
    if one.height is not None and two.height is not None:
        meets &= ~are_apart(one.height[:, None], two.height[None])
    if not np.count_nonzero(meets):
        return None
    there: Booleans = np.asarray(meets.any(axis=1))
    begins = there.copy()
    begins[1:] &= ~there[:-1]
    begins[2:] &= ~there[:-2]
    number = np.cumsum(begins, axis=0)
    found = []
    for place in (number == 1, number > 1):
        in_place = meets & place[:, None]
        found.append(
            [
                _ends(line, np.asarray(in_place.any(axis=axis)))
                for line, axis in ((one, 1), (two, 0))
            ]
        )
    ends = np.array(found)  # (place, of the pair, enter or leave, P)
    enter, leave = (np.concatenate(list(ends[:, :, which]), axis=1) for which in (0, 1))
    return enter, leave


def _ends(samples: _Samples, there: Booleans) -> tuple[Floats, Floats]:
    """(P,) meters from the front to the first sample that is `there` (M, P), infinite for none, and
    until the rear has left the last."""
    half = -samples.s[0]
    enter = np.where(there, samples.s, math.inf).min(axis=0) - half
    return enter, np.where(there, samples.s, -math.inf).max(axis=0) + half + SPACING
