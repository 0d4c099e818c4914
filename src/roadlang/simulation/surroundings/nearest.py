"""Who else is near: the nearest other agents of some agents, as the crow flies."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from ...geometry.areas.levels import are_apart
from ...geometry.arrays import Floats, Integers
from ..state.world import World
from ..vehicles.poses import Poses
from .levels import ground_heights


def nearest(
    world: World, poses: Poses, rows: Integers, count: int
) -> tuple[Floats, Floats, Floats, Floats]:
    """(R, count) x, y, heading and speed of the nearest other agents of the agents `rows`, nearest
    first; NaN where a scene has no more. Who is on another level is not seen."""
    if world.slots == 1:
        return nobody(len(rows), count)
    out = np.full((4, len(rows), count), math.nan)
    shape = (len(world.scenes), world.slots)
    scene, place = rows // world.slots, rows % world.slots
    x, y = poses.x.reshape(shape)[scene], poses.y.reshape(shape)[scene]
    off_x, off_y = x - poses.x[rows][:, None], y - poses.y[rows][:, None]
    square = off_x * off_x + off_y * off_y
    square[~world.present.reshape(shape)[scene]] = math.inf
    square[np.arange(len(rows)), place] = math.inf
    if world.heights is not None:
        height = ground_heights(world).reshape(shape)
        away = np.sqrt(square)
        square[are_apart(height[scene], height[scene, place][:, None], away)] = math.inf
    first = np.argsort(square, axis=1, kind="stable")[:, :count]
    missing = ~np.isfinite(np.take_along_axis(square, first, axis=1))
    agents = scene[:, None] * world.slots + first
    for place_in, column in enumerate((poses.x, poses.y, poses.heading, world.motion.speed)):
        found = column[agents]
        found[missing] = math.nan
        out[place_in, :, : first.shape[1]] = found
    return out[0], out[1], out[2], out[3]


@lru_cache(maxsize=8)
def nobody(rows: int, count: int) -> tuple[Floats, Floats, Floats, Floats]:
    """What `nearest` gives of agents that are alone."""
    column = np.broadcast_to(np.float64(math.nan), (rows, count))
    return column, column, column, column
