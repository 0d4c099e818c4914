"""Lane changes of routes: who changes lanes and who drives in the lane it changes to fall in behind
one another, in the order in which they are along the road."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats
from ..state.world import World

PREPARED = 3.0
"""Seconds before a lane change from which on agents make room."""
LEAST_DISTANCE = 10.0
"""Meters before it from which on they do, at least."""

BESIDE = 1.0
"""Meters between the bumpers of two up to which they count as side by side."""


def zipper(world: World) -> tuple[Floats, Floats, Floats]:
    """(N,) gap of each agent to the next that is to be ahead of it because one of them changes
    lanes, infinite for nobody, and the speed of that one. Gaps of agents side by side are
    negative. And how far before the front of an agent it has to stop, because there it would be in
    a lane in which somebody is beside it; infinite for no need."""
    count = len(world.present)
    gap, speed, stop = np.full(count, math.inf), np.zeros(count), np.full(count, math.inf)
    if not world.table.has_changes:
        return gap, speed, stop
    along, half = world.motion.along, 0.5 * world.bodies.length
    last = along + np.maximum(LEAST_DISTANCE, PREPARED * world.motion.speed) + half
    changes_lane, least, most = world.table.lane_changes(slice(None), along, along - half, last)
    shape = len(world.scenes), world.slots
    changing = (changes_lane & world.has_route & world.present & ~world.halted).reshape(shape)
    scenes = np.flatnonzero(changing.any(axis=1))
    if not len(scenes):
        return gap, speed, stop
    # Who is on a connection is already in line with those on the lane it leads to.
    place = world.table.coming_place(slice(None), along)
    station = np.where(world.has_route, place.station, world.station)
    columns: tuple[Any, ...] = (
        np.where(place.turn < 0, place.road, -1), place.direction, place.lane, least, most,
        station, half, world.motion.speed,
    )  # fmt: skip
    road, direction, lane, low, high, station, half_length, pace = (
        column.reshape(shape)[scenes] for column in columns
    )
    changes = changing[scenes]
    low, high = np.where(changes, low, lane), np.where(changes, high, lane)
    same = (road[:, :, None] == road[:, None, :]) & (road >= 0)[:, :, None]
    same &= direction[:, :, None] == direction[:, None, :]
    same &= world.present.reshape(shape)[scenes][:, None, :]
    into = (low[:, :, None] <= lane[:, None, :]) & (lane[:, None, :] <= high[:, :, None])
    meets = (low[:, :, None] <= high[:, None, :]) & (low[:, None, :] <= high[:, :, None])
    meets |= into | np.swapaxes(into, 1, 2)
    either = (changes[:, :, None] | changes[:, None, :]) & same & meets
    ahead = direction[:, :, None] * (station[:, None, :] - station[:, :, None])
    enters = (world.table.enters_lane(slice(None), along) - along - half).reshape(shape)[scenes]
    apart, waits = _order(changes, either, either & into, ahead, half_length, enters)
    first = apart.argmin(axis=2)
    gap.reshape(shape)[scenes] = np.take_along_axis(apart, first[:, :, None], axis=2)[:, :, 0]
    speed.reshape(shape)[scenes] = np.take_along_axis(pace, first, axis=1)
    stop.reshape(shape)[scenes] = np.where(waits.any(axis=2), enters, math.inf)
    return gap, speed, stop


def _order(
    changes: Booleans, either: Booleans, into: Booleans, ahead: Floats, half_length: Floats,
    enters: Floats,
) -> tuple[Floats, Booleans]:  # fmt: skip
    """(S, A, A) the gaps to those that go ahead, and whether the first stops before it is in the
    lane of the second. Who changes to the lane of somebody beside it lets that one go ahead. Of
    pairs: whether either changes lanes, whether the first does so `into` the lane of the second,
    and how far `ahead` that one is; `changes`, and how far before a front the other lane begins:
    (S, A)."""
    numbers = np.arange(changes.shape[1])
    later = (ahead > 0.0) | (ahead == 0.0) & (numbers[None, :] < numbers[:, None])
    lengths = half_length[:, :, None] + half_length[:, None, :]
    beside = either & (np.abs(ahead) < lengths + BESIDE) & (numbers[None, :] != numbers[:, None])
    in_front = ahead + half_length[:, None, :] > half_length[:, :, None]
    yields = (changes & np.isfinite(enters))[:, :, None]
    yields = yields & (in_front | (enters > -BESIDE)[:, :, None])
    alone = beside & yields & into & ~changes[:, None, :]
    waits = np.where(changes[:, None, :], beside & later & yields, alone)
    passes = np.swapaxes(alone, 1, 2)
    return np.where(either & later & ~passes, ahead, math.inf) - lengths, waits
