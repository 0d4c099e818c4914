"""When others come the other way on a stretch of road that an agent would like to use.

Where they come from is looked up on the lines that they follow, so that those who will turn into
the road at a junction count as well as those who are on it.
"""

from __future__ import annotations

import math

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..state.world import World
from ..vehicles.poses import Poses, frames_ahead
from .levels import apart_at, ground_heights

SPACING, VIEW = 3.0, 150.0
"""Meters between two places of a line, and how far others are looked for."""
_PLACES_AT_ONCE = 8192
"""Places of others that are looked at together, so few that they fit into the caches."""
BESIDE = 0.6
"""Meters between the sides of two that meet, at least."""
SAME_WAY = 0.3
"""Cosine of the angle between two lines, at least, from which on they lead the same way."""
GAINS, FAST = 1.5, 10.0
"""m/s^2 and m/s: who is slower than that may be expected to gain speed."""
TURN, TURNS = 0.5, 8
"""Seconds for which one of two that wait for each other may begin, and after how many such times it
is its turn again."""


def comes_toward(
    world: World, poses: Poses, rows: Integers, stretch: tuple[Floats, Floats],
    ends: tuple[Floats, Floats], stranded: Booleans | None = None,
) -> Floats:  # fmt: skip
    """(R,) seconds until another vehicle may be on the stretches ahead of agents, going another
    way; infinite for nobody.

    `stretch`: (R,) how far left of their reference lines agents want to go, and until how many
    meters ahead. `ends`: (N,) gaps of all agents to the objects in their ways, and to where they
    wait for others. Who stands before an object does not come; of two that both do, each may begin
    in its turn. Nor does who is `stranded` (N,). For an agent inside a junction, those that wait go
    on waiting.
    """
    obstacles, stops = ends
    out = np.full(len(rows), math.inf)
    place, other = np.nonzero(_may_come(world, poses, rows, stranded))
    if not len(place):
        return out
    other = rows[place] // world.slots * world.slots + other
    gap = _gaps(world, rows, stretch, (place, other))
    gap = gap - 0.5 * world.bodies.length[other]
    met = np.isfinite(gap)
    if not met.any():
        return out
    place, other, gap = place[met], other[met], np.maximum(gap[met], 0.0)
    if world.heights is not None:
        here = ground_heights(world)[rows[place]]
        far = world.motion.along[other] + gap
        gap = np.where(apart_at(world, other, far, here), math.inf, gap)
    speed = world.motion.speed[other]
    gaining = (np.sqrt(speed * speed + 2.0 * GAINS * gap) - speed) / GAINS
    time = np.maximum(gaining, gap / np.maximum(speed, FAST))
    inside = world.table.place(rows, world.motion.along[rows]).turn >= 0
    time = np.where(inside[place] & (stops[other] < gap), math.inf, time)
    blocked = obstacles[other] < gap
    number = np.floor(world.age[rows[place]] / TURN + 1e-6)
    its_turn = number % TURNS == (rows[place] % world.slots) % TURNS
    time = np.where(blocked & np.isfinite(time), np.where(its_turn, math.inf, 0.0), time)
    np.minimum.at(out, place, time)
    return out


def _may_come(world: World, poses: Poses, rows: Integers, stranded: Booleans | None) -> Booleans:
    """(R, A) which others of their scenes are vehicles that can move, and near enough."""
    shape = (len(world.scenes), world.slots)
    scene = rows // world.slots
    moves = world.present & world.has_road & ~world.halted & ~world.bodies.walks
    moves = moves if stranded is None else moves & ~stranded
    may = moves.reshape(shape)[scene]
    off_x = poses.x.reshape(shape)[scene] - poses.x[rows, None]
    off_y = poses.y.reshape(shape)[scene] - poses.y[rows, None]
    may &= off_x * off_x + off_y * off_y < VIEW * VIEW
    may[np.arange(len(rows)), rows % world.slots] = False
    return np.asarray(may)


def _gaps(
    world: World, rows: Integers, stretch: tuple[Floats, Floats], pairs: tuple[Integers, Integers]
) -> Floats:
    """(P,) meters along the lines of others to where they meet the stretches, on the lines beside
    or on those that agents follow now; infinite for those that do not."""
    place, other = pairs
    line, reach = stretch
    agent = rows[place]
    ahead = np.arange(0.0, float(reach.max()) + SPACING, SPACING)
    here = _line(world, rows, ahead, line), _line(world, rows, ahead, None)
    there = _line(world, other, np.arange(0.0, VIEW, SPACING), None)
    width = 0.5 * (world.bodies.width[agent] + world.bodies.width[other]) + BESIDE
    out = np.full(len(place), math.inf)
    distance = np.arange(0.0, VIEW, SPACING)
    limit = width * width + SPACING * SPACING
    count = max(1, _PLACES_AT_ONCE // there[0].size)
    for x, y, heading in here:
        for begin in range(0, len(ahead), count):
            steps = slice(begin, begin + count)
            off_x = there[0] - x[steps, None, place]
            off_y = there[1] - y[steps, None, place]
            near = off_x * off_x + off_y * off_y < limit
            near &= (ahead[steps, None] <= reach[place])[:, None]
            if near.any():
                near &= np.cos(there[2] - heading[steps, None, place]) < SAME_WAY
                first = np.where(near, distance[:, None], math.inf).min(axis=(0, 1))
                out = np.minimum(out, first)
    return out


def _line(
    world: World, rows: Integers, ahead: Floats, left: Floats | None
) -> tuple[Floats, Floats, Floats]:
    """(K, R) x, y and heading `ahead` of agents on lines so far left of their reference lines, or
    on those that they follow."""
    track = world.track.of_rows(rows)
    along = world.motion.along[rows] + ahead[:, None]
    past = along > world.length[rows] + SPACING
    along = track.wrapped(along)
    _, (x, y, heading, _, _) = frames_ahead(track, along)
    offset = world.followed.offset(rows, along) if left is None else left
    x, y = x - np.sin(heading) * offset, y + np.cos(heading) * offset
    return np.where(past & ~world.closed[rows], math.nan, x), y, heading
