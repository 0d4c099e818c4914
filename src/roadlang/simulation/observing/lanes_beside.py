"""The lanes that lie beside those of agents, on roads and across junctions."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ...geometry.arrays import Floats, Integers
from ...ir.surroundings import LanesBeside
from ..state.world import World
from .surroundings import Surroundings

EDGE = 0.2
"""Meters before and behind a junction at which the lanes of its roads are looked up: more
than directions of travel are probed with (`road_places.py`)."""


def lanes_beside(
    world: World, surroundings: Surroundings, rows: Integers, ahead: Floats, line: Floats
) -> LanesBeside:
    """The lanes `ahead` (N,) meters on of agents, at lines (N,), and those beside; NaN for none.

    Inside a junction lanes lead straight from those of the road before it to those of the road
    behind it, seen from the middle of the lane that is followed. There is one beside it only where
    both roads have one, and traffic goes the same way on these.
    """
    along = world.motion.along.copy()
    along[rows] += np.where(np.isfinite(ahead), ahead, 0.0)
    found = _on_roads(world, surroundings, rows, along, line)
    along = world.track.wrapped(along)
    inside = world.table.place(slice(None), along).turn[rows] >= 0
    if not inside.any():
        return LanesBeside(*found)
    begin, end = world.table.leg_ends(slice(None), along)
    edges = (
        np.where(np.isfinite(begin), begin, 0.0) - EDGE,
        np.where(np.isfinite(end), end, world.length) + EDGE,
    )
    before, behind = (_on_roads(world, surroundings, rows, edge, line) for edge in edges)
    share = ((along - edges[0]) / (edges[1] - edges[0]))[rows]
    across = [one + share * (other - one) for one, other in zip(before, behind, strict=True)]
    for side in (2, 4):
        unlike = before[side + 1] != behind[side + 1]
        across[side] = np.where(unlike, math.nan, across[side])
        across[side + 1] = np.where(unlike, math.nan, before[side + 1])
    return LanesBeside(
        *(np.where(inside, one, other) for one, other in zip(across, found, strict=True))
    )


def _on_roads(
    world: World, surroundings: Surroundings, rows: Integers, along: Floats, line: Floats
) -> list[Any]:
    """(N,) the columns of `LanesBeside` at arc lengths (all agents) of lines; in junctions NaN."""
    lanes = surroundings.lanes(world, along - world.motion.along).take(rows)
    place, each = lanes.place(line), np.arange(len(rows))
    columns = [place.offset, place.width]
    for side in (lanes.choose(word, line) for word in ("left", "right")):
        columns += [
            np.where(side >= 0, column[each, side], math.nan)
            for column in (lanes.middles, lanes.direction)
        ]
    return columns
