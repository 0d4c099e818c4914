"""Lanes that end: those beside them let in, one after the other, who has to leave them, and who
leaves falls in behind who is ahead there."""

from __future__ import annotations

import math

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene import SceneRoad
from ...plugins.kinds import LANE_END_GAP
from ..lanes.road_lanes import LanesHere
from ..state.world import World
from ..surroundings.leaders import Leaders
from ..surroundings.road_gaps import SAME_LANE
from ..traffic.rules import COURTEOUS

STOPPING = 2.5
"""A vehicle that finds no gap brakes with this many m/s^2 to stop `LANE_END_GAP` before the end of
its lane. The vehicles beside it have made room by the time it would have to begin to brake."""
WITHIN, WITHIN_TIME = 60.0, 4.0
"""The vehicles beside it begin to make room at least `WITHIN` meters before the end of its lane,
and at least `WITHIN_TIME` seconds before it would have to begin to brake."""
JOINED = 60.0
"""Meters after the end of a lane at which who drives there is in the lane that goes on."""
ROOM = 0.4
"""Meters that the gap to a vehicle in the lane that ends may still lack, for each meter that this
vehicle can drive before it would have to begin to brake."""
CLEAR, ROLLING = 2.0, 3.0
"""Meters from bumper to bumper in which one that stands can pull out; m/s from which on the gap may
still open."""
SOONEST = 0.5
"""Seconds that two side by side have at least to fall in one after the other."""


def has_lane_endings(roads: list[SceneRoad]) -> bool:
    """Whether a lane for vehicles of any road ends on the way. Roads that are bent in many ways
    share their lanes, which are looked at once."""
    lists = {id(road.lane_list): road.lane_list for road in roads}
    return any(
        lane.drivable and len(lane.width) > 1 and min(lane.width) < 0.5 * max(lane.width)
        for lanes in lists.values()
        for lane in lanes
    )


def lets_in(
    world: World, lanes: LanesHere, leaders: Leaders, rows: Integers, politeness: Floats | float
) -> tuple[Floats, Floats]:
    """(n,) gaps of agents to the next agent ahead in a lane that ends soon and becomes one with
    theirs, or in any such lane if theirs ends soon, infinite for none, and the speed of that one.
    They merge like a zipper: each lets in one, and an agent ahead of its own leader is for the
    leader to let in. An agent whose lane ends also falls in behind one beside it. `politeness`:
    from 0, nobody, to 1; agents whose lanes end have no choice.
    """
    shape = len(world.scenes), world.slots
    left = world.motion.offset
    end = np.where(world.present & world.has_road & ~world.has_route, lanes.end(left), np.inf)
    end = np.where(world.bodies.walks, np.inf, end).reshape(shape)
    last, within = _reach(np.maximum(world.motion.speed, 0.0).reshape(shape))
    leaves = end < within
    if not leaves.any():
        return np.full(len(rows), math.inf), np.zeros(len(rows))
    along, left, road, half, pace = (
        column.reshape(shape)
        for column in (
            np.where(world.backward, -1.0, 1.0) * world.station, left,
            np.where(world.has_route, -1, world.road), 0.5 * world.bodies.length,
            world.motion.speed,
        )
    )  # fmt: skip
    polite = np.full(len(world.present), -1.0)
    polite[rows] = politeness
    ahead = along[:, None, :] - along[:, :, None]
    aside = np.abs(left[:, None, :] - left[:, :, None])
    gap = ahead - half[:, :, None] - half[:, None, :]
    room = _makes_room(gap, ahead, pace, np.minimum(end, within), polite)
    into, behind = _orders(gap, ahead, pace, leaves, room)
    comes = (into | behind) & (road[:, :, None] == road[:, None, :]) & (road >= 0)[:, :, None]
    comes &= _same_way(world, shape) & (aside > SAME_LANE)
    comes &= _join(world, np.where(leaves, end, np.inf), comes)
    comes &= behind | (gap > CLEAR) | (pace > ROLLING)[:, None, :]
    comes &= gap < leaders.gap.reshape(shape)[:, :, None]
    spare = ROOM * np.minimum(pace / ROLLING, 1.0)
    spare *= np.maximum(np.minimum(end, within) - last, 0.0)
    spare = np.where(leaves[:, :, None], spare[:, :, None], spare[:, None, :])
    decided = behind | ((gap < CLEAR) & (pace > ROLLING)[:, :, None])
    gap = np.where(comes, gap + spare, np.inf)
    least, speed, first = _nearest_of(gap, pace, decided, rows)
    first |= _is_polite(world.motion.speed[rows] - speed, least, politeness)
    return np.where(first, least, np.inf), speed


def _orders(
    gap: Floats, ahead: Floats, pace: Floats, leaves: Booleans, makes_room: Booleans
) -> tuple[Booleans, Booleans]:
    """(S, A, A) whom the first would let in, and behind whom it falls in as its own lane ends."""
    into = leaves[:, None, :] & ~leaves[:, :, None] & (ahead > 0.0)
    # Of two side by side that hardly move, the one whose middle is ahead goes first.
    refused = into & (gap < CLEAR) & (pace > ROLLING)[:, :, None] & ~makes_room
    behind = leaves[:, :, None] & ((ahead > 0.0) | np.swapaxes(refused, 1, 2))
    return into & ~refused, behind


def _reach(speed: Floats) -> tuple[Floats, Floats]:
    """Meters before the end of its lane at which an agent at `speed` would begin to brake for it,
    and those from which on the others make room for it."""
    last = LANE_END_GAP + speed * speed / (2.0 * STOPPING)
    return last, np.maximum(WITHIN, last + WITHIN_TIME * speed)


def _nearest_of(
    gap: Floats, pace: Floats, decided: Booleans, rows: Integers
) -> tuple[Floats, Floats, Booleans]:
    """(n,) the least gap (S, A, A) of some agents, the speed (S, A) of the agent there, and whether
    it is `decided` (S, A, A) that that one goes first."""
    first = gap.argmin(axis=2)
    each = first[:, :, None]
    least = np.take_along_axis(gap, each, axis=2).ravel()[rows]
    goes_first = np.take_along_axis(decided, each, axis=2).ravel()[rows]
    return least, np.take_along_axis(pace, first, axis=1).ravel()[rows], goes_first


def _join(world: World, end: Floats, comes: Booleans) -> Booleans:
    """(S, A, A) of the pairs that count, those whose lines are one after the lane of one of them
    has ended, `end` (S, A) meters ahead of it."""
    out = np.zeros_like(comes)
    scene, first, second = np.nonzero(comes)
    one, other = scene * world.slots + first, scene * world.slots + second
    station = np.where(world.backward, -1.0, 1.0) * world.station
    ends = station + end.ravel()
    there = np.minimum(ends[one], ends[other]) + JOINED
    offset = [_line_at(world, rows, there - station[rows]) for rows in (one, other)]
    out[scene, first, second] = np.abs(offset[0] - offset[1]) < SAME_LANE
    return out


def _line_at(world: World, rows: Integers, ahead: Floats) -> Floats:
    """(P,) where the lines of agents are `ahead` of them, once they have changed lanes."""
    followed = world.followed
    if not followed.guided:
        return followed.lateral.offset[rows]
    guide = followed.guide[rows]
    offset = followed.guides.offset(guide, world.motion.along[rows] + ahead)
    return np.where(guide >= 0, offset, followed.lateral.offset[rows])


def _makes_room(
    gap: Floats, ahead: Floats, pace: Floats, end: Floats, politeness: Floats
) -> Booleans:
    """(S, A, A) whether the first falls back until the second, whose lane ends and whose middle is
    ahead, fits in before it: braking evenly until then, no harder than it is polite, or in an
    emergency less hard than the second to fall back behind it. `politeness`: (N,), negative for who
    does not react."""
    seconds = np.maximum(end / np.maximum(pace, ROLLING), SOONEST)[:, None, :]
    faster = pace[:, :, None] - pace[:, None, :]
    back = CLEAR - gap + np.maximum(faster, 0.0) * seconds
    other_back = CLEAR + 2.0 * ahead - gap + np.maximum(-faster, 0.0) * seconds
    needed, others = (2.0 * way / (seconds * seconds) for way in (back, other_back))
    most = COURTEOUS * politeness.reshape(pace.shape)[:, :, None]
    emergency = (others > COURTEOUS) & (needed < others)
    return np.asarray((most >= 0.0) & (emergency | (needed < most)))


def _is_polite(closing: Floats, gap: Floats, politeness: Floats | float) -> Booleans:
    """(n,) whether somebody lets in who is `gap` ahead and slower by `closing`, m/s."""
    faster = np.maximum(closing, 0.0)
    needed = faster * faster / (2.0 * np.maximum(gap, 0.1))
    return np.asarray(needed < COURTEOUS * np.asarray(politeness))


def _same_way(world: World, shape: tuple[int, int]) -> Booleans:
    """(S, A, A) who of a road goes in the same direction."""
    back = world.backward.reshape(shape)
    return np.asarray(back[:, :, None] == back[:, None, :])
