"""Who is next ahead in the lane."""

from __future__ import annotations

import math

import numpy as np

from ..geometry.arrays import Booleans, Floats
from .poses import Poses
from .world import World

SAME_LANE = 2.0
"""Meters: beside each other rather than behind one another, from here on."""
EVERY = 3
"""Cells of a line that are skipped in the search for the place of an agent of another road."""
NEAR = 150.0
"""Meters, as the crow flies: who is farther away is not ahead."""


def leaders(world: World, poses: Poses) -> tuple[Floats, Floats]:
    """(N,) the gap to the next agent ahead in the lane of each, infinite for none, and that one's
    speed along the lane."""
    shape = (len(world.scenes), world.slots)
    ahead, beside = _places(world, poses, shape)
    own = world.line_offset.reshape(shape)[:, :, None]
    length = world.bodies.length.reshape(shape)
    road = world.length.reshape(shape)[:, :, None]
    closed = world.closed.reshape(shape)[:, :, None]
    around = closed & np.isfinite(ahead)
    ahead = np.where(around, ahead - np.floor(np.where(around, ahead, 0.0) / road) * road, ahead)
    gap = ahead - 0.5 * (length[:, :, None] + length[:, None, :])
    there = world.present.reshape(shape)
    fits = (ahead > 0.0) & (np.abs(beside - own) < SAME_LANE)
    fits &= (there & world.has_road.reshape(shape))[:, :, None] & there[:, None, :]
    gap = np.where(fits, gap, math.inf)
    first = gap.argmin(axis=2)
    least = np.take_along_axis(gap, first[:, :, None], axis=2)[:, :, 0]
    heading = poses.heading.reshape(shape)
    speed = np.take_along_axis(world.motion.speed.reshape(shape), first, axis=1)
    turned = np.take_along_axis(heading, first, axis=1) - heading
    along = np.where(np.isfinite(least), speed * np.cos(turned), 0.0)
    return least.ravel(), along.ravel()


def _places(world: World, poses: Poses, shape: tuple[int, int]) -> tuple[Floats, Floats]:
    """(S, A, A) how far ahead the second is on the line of the first, and how far to its left."""
    sign = np.where(world.backward, -1.0, 1.0).reshape(shape)
    road = world.road.reshape(shape)
    station = world.station.reshape(shape)
    left = (np.where(world.backward, -1.0, 1.0) * world.motion.offset).reshape(shape)
    ahead = sign[:, :, None] * (station[:, None, :] - station[:, :, None])
    beside = sign[:, :, None] * left[:, None, :]
    itself = np.eye(shape[1], dtype=bool)[None]
    ahead = np.where(itself, -math.inf, ahead)
    there = world.present.reshape(shape)
    elsewhere = (road[:, :, None] != road[:, None, :]) & (road >= 0)[:, :, None] & ~itself
    elsewhere &= there[:, :, None] & there[:, None, :]
    if elsewhere.any():
        _search(world, poses, elsewhere, ahead, beside)
    return ahead, beside


def _search(world: World, poses: Poses, elsewhere: Booleans, ahead: Floats, beside: Floats) -> None:
    """Fill in the places of agents on the lines of other roads: the nearest point of each."""
    lines = world.track.lines
    for scene, first, second in zip(*np.nonzero(elsewhere), strict=True):
        one, other = scene * world.slots + first, scene * world.slots + second
        x, y = poses.x[other], poses.y[other]
        if max(abs(x - poses.x[one]), abs(y - poses.y[one])) > NEAR:
            ahead[scene, first, second] = -math.inf
            continue
        start = int(world.track.row[one]) * lines.cells
        stop = start + int(lines.last[world.track.row[one]]) + 1
        off_x, off_y = x - lines.x[start:stop:EVERY], y - lines.y[start:stop:EVERY]
        cell = int((off_x * off_x + off_y * off_y).argmin())
        heading = lines.heading[start + cell * EVERY]
        cosine, sine = np.cos(heading), np.sin(heading)
        beyond = cosine * off_x[cell] + sine * off_y[cell]
        begins = world.track.origin[one] + cell * EVERY * world.track.spacing[one]
        ahead[scene, first, second] = begins + beyond - world.motion.along[one]
        beside[scene, first, second] = cosine * off_y[cell] - sine * off_x[cell]
