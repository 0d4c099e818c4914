"""Which agents are so near to others that they may be ahead of these; compiled where numba is
loaded, with the same formulas and to the same bits."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..state.world import World
from ..vehicles import compiled
from ..vehicles.poses import Poses
from .sorted_groups import sorted_groups

LEAST_VIEW, MOST_VIEW = 50.0, 150.0
"""Meters that agents look ahead, standing and at most."""
VIEW_TIME = 4.0
"""Seconds of its speed that an agent looks further."""


@dataclass(frozen=True)
class PairsAhead:
    """Pairs (P,) of an agent, in ascending order, and another."""

    agent: Integers
    target: Integers
    agents: Integers
    """(I,) who is the first of any"""
    column: Integers
    """(P,) where it is among these"""

    @classmethod
    def of(cls, agent: Integers, target: Integers) -> PairsAhead:
        """Of agents in ascending order."""
        agents, _, column = sorted_groups(agent)
        return cls(agent, target, agents, column)


def looks_ahead(world: World) -> Floats:
    """(N,) meters."""
    view: Floats = view_at(world.motion.speed)
    return view


def view_at(speed: Any) -> Any:
    """Meters that agents look ahead. Of columns, and of numbers in the compiled loops."""
    return np.minimum(LEAST_VIEW + VIEW_TIME * speed, MOST_VIEW)


def near_pairs(world: World, poses: Poses, pairs: Booleans, radius: Floats) -> PairsAhead:
    """Of the `pairs` (S, A, A), those of two who are present, of which the first looks as far as
    the second. `radius`: (S, A) around agents."""
    if compiled.is_loaded():
        out = np.empty((3, pairs.size), dtype=np.int64)
        agents = np.empty(len(world.present), dtype=np.int64)
        columns = poses.x, poses.y, world.motion.speed, world.present
        count, groups = _loop()(pairs, radius, columns, out, agents)
        agent, target, column = out[:, :count]
        return PairsAhead(agent, target, agents[:groups], column)
    shape = radius.shape
    there = world.present.reshape(shape)
    both = there[:, :, None] & there[:, None, :]
    x, y = poses.x.reshape(shape), poses.y.reshape(shape)
    view = looks_ahead(world).reshape(shape)[:, :, None] + radius[:, None, :]
    near = pairs & both & (np.abs(x[:, None, :] - x[:, :, None]) < view)
    near &= np.abs(y[:, None, :] - y[:, :, None]) < view
    scene, first, second = near.nonzero()
    return PairsAhead.of(scene * world.slots + first, scene * world.slots + second)


def loop_over_pairs_near(pairs: Any, radius: Any, there: Any, out: Any, agents: Any) -> Any:
    """Fill `out`, (3, at least P), with agents, targets and columns, and `agents`, (at least I,).
    P and I. numba compiles it; Python never runs it."""
    x, y, speed, present = there
    scenes, slots = radius.shape
    count, groups = 0, 0
    for scene in range(scenes):
        for first in range(slots):
            i, before = scene * slots + first, count
            view = view_at(speed[i])
            for second in range(slots):
                j = scene * slots + second
                if not (present[i] and present[j] and pairs[scene, first, second]):
                    continue
                reach = view + radius[scene, second]
                if abs(x[j] - x[i]) < reach and abs(y[j] - y[i]) < reach:
                    out[0, count], out[1, count], out[2, count] = i, j, groups
                    count += 1
            if count > before:
                agents[groups] = i
                groups += 1
    return count, groups


@cache
def _loop() -> Any:
    compiled.register((view_at,), (loop_over_pairs_near,))
    return compiled.compile_loop(loop_over_pairs_near, sys.modules[__name__])
