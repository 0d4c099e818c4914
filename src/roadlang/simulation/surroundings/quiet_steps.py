"""Steps in which nobody comes near anybody: told by a compiled loop, without exact poses."""

from __future__ import annotations

import sys
from functools import cache
from typing import Any

import numpy as np

from ...geometry.arrays import Floats, Integers
from ..lines import lines
from ..state.world import World
from ..vehicles import compiled, kernels

MARGIN = 1e-3
"""Meters by which places and ways may be off: the sine is not numpy's."""


def quiet_step(
    world: World, pairs: tuple[Integers, Integers], radius: Floats, before: Floats
) -> tuple[Floats, float] | None:
    """Where agents are, (2, N) within `MARGIN`, and how far whoever went farthest has come since
    they were at `before`; None where a pair (P,) of agents, of which each has a radius (N,), may
    have met in between."""
    track, motion = world.track, world.motion
    found = np.empty((2, len(radius)))
    step = _loop()(
        (motion.along, motion.offset, motion.line_heading),
        (track.first, track.places, track.lines.table), before, pairs, radius,
        (world.present, world.halted), found,
    )  # fmt: skip
    return (found, step) if step >= 0.0 else None


def loop_over_steps(
    motion: Any, track: Any, before: Any, pairs: Any, radius: Any, flags: Any, found: Any
) -> Any:  # fmt: skip
    """Fill `found`, (2, N), with where agents are. How far whoever went farthest has come since
    they were at `before`, (2, N); -1 where a pair may have met. numba compiles it; Python never
    runs it."""
    (along, offset, heading), (first, numbers, table) = motion, track
    (one, other), (present, halted) = pairs, flags
    way, farthest = np.empty(radius.shape[0]), 0.0
    for i in range(radius.shape[0]):
        last, origin, spacing, per_meter = numbers[:, i]
        advance, part = kernels.place_on_line(along[i], last, origin, per_meter)
        rest = advance - int(part) * spacing
        x, y, _ = lines.on_arc(table[first[i] + int(part)], rest, spacing)
        found[0, i] = x - np.sin(heading[i]) * offset[i]
        found[1, i] = y + np.cos(heading[i]) * offset[i]
        off_x, off_y = found[0, i] - before[0, i], found[1, i] - before[1, i]
        way[i] = np.sqrt(off_x * off_x + off_y * off_y) + MARGIN
        farthest = way[i] if way[i] > farthest else farthest
    for p in range(one.shape[0]):
        i, j = one[p], other[p]
        off_x, off_y = found[0, i] - found[0, j], found[1, i] - found[1, j]
        reach = radius[i] + radius[j] + way[i] + way[j] + MARGIN
        are_far = off_x * off_x + off_y * off_y > reach * reach
        counts = present[i] and present[j] and not (halted[i] and halted[j])
        if counts and not are_far:  # what is no number is looked at more closely
            return -1.0
    return farthest


@cache
def _loop() -> Any:
    compiled.register((), (loop_over_steps,))
    return compiled.compile_loop(loop_over_steps, sys.modules[__name__])
