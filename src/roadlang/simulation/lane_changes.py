"""Lane changes of routes: who changes lanes and who drives in the lane it changes to fall in behind
one another, in the order in which they are along the road."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..geometry.arrays import Floats
from .world import World

PREPARED = 3.0
"""Seconds before a lane change from which on agents make room."""
LEAST_DISTANCE = 10.0
"""Meters before it from which on they do, at least."""


def zipper(world: World) -> tuple[Floats, Floats]:
    """(N,) gap of each agent to the next that is to be ahead of it because one of them changes
    lanes, infinite for nobody, and the speed of that one. Gaps of agents side by side are
    negative."""
    count = len(world.present)
    gap, speed = np.full(count, math.inf), np.zeros(count)
    if not world.table.has_changes:
        return gap, speed
    along, half = world.motion.along, 0.5 * world.bodies.length
    before = np.maximum(LEAST_DISTANCE, PREPARED * world.motion.speed) + half
    changes_lane, least, most = world.table.lane_changes(slice(None), along - half, along + before)
    shape = len(world.scenes), world.slots
    changing = (changes_lane & world.has_route & world.present & ~world.halted).reshape(shape)
    scenes = np.flatnonzero(changing.any(axis=1))
    if not len(scenes):
        return gap, speed
    place = world.place
    columns: tuple[Any, ...] = (
        np.where(place.turn < 0, place.road, -1), place.direction, place.lane, least, most,
        world.station, half, world.motion.speed,
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
    numbers = np.arange(shape[1])
    tie = (ahead == 0.0) & (numbers[None, :] < numbers[:, None])
    apart = np.where(either & ((ahead > 0.0) | tie), ahead, math.inf)
    apart = apart - half_length[:, :, None] - half_length[:, None, :]
    first = apart.argmin(axis=2)
    gap.reshape(shape)[scenes] = np.take_along_axis(apart, first[:, :, None], axis=2)[:, :, 0]
    speed.reshape(shape)[scenes] = np.take_along_axis(pace, first, axis=1)
    return gap, speed
