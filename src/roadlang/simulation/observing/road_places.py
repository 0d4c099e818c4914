"""Where on their roads agents would be at other arc lengths of their lines."""

from __future__ import annotations

import numpy as np

from ...geometry.arrays import Booleans, Floats
from ..state.world import World

PROBE = 0.1
"""Meters along a route to each side, to see in which direction of the road it goes."""


def stations_at(world: World, along: Floats) -> Floats:
    """(N,) arc lengths along the roads, within their ends, where those of the lines are `along`."""
    if along is world.motion.along:
        return world.station
    along = np.minimum(np.maximum(along, 0.0), world.length)
    station = np.where(world.backward, world.length - along, along)
    rows = world.has_route.nonzero()[0]
    if len(rows):
        station[rows] = world.table.station(rows, along[rows])
    return station


def are_backward(world: World, along: Floats) -> Booleans:
    """(N,) who goes against the direction of the road at arc lengths of its line."""
    out = world.backward.copy()
    rows = np.flatnonzero(world.has_route)
    if len(rows):
        there = along[rows]
        ends = [world.table.station(rows, there + off) for off in (-PROBE, PROBE)]
        out[rows] = ends[1] < ends[0]
    return out
