"""The same motion, compiled by numba where that is installed: the same formulas, the same bits."""

from __future__ import annotations

import importlib.util
from functools import cache
from typing import Any

import numpy as np

from ..geometry.arrays import Floats, Integers
from . import lines, vehicle
from .bodies import Bodies
from .motion import Motion, Track


@cache
def is_installed() -> bool:
    """Whether there is a numba (`pip install roadlang[fast]`)."""
    return importlib.util.find_spec("numba") is not None


def advance(
    motion: Motion, car: Bodies, track: Track, wanted: tuple[Floats, Floats], steps: int, dt: float
) -> None:
    """What `motion.advance` does, to the last bit."""
    before = (
        motion.along, motion.offset, motion.speed, motion.slide, motion.yaw_rate, motion.cosine,
        motion.sine, motion.tangent, motion.line_heading, motion.acceleration,
    )  # fmt: skip
    after = np.empty((len(before), len(motion.along)))
    places = (track.first, track.places)
    kernel()((before, after), car.stacked, car.walks, wanted, places, track.lines.table, steps, dt)
    (
        motion.along, motion.offset, motion.speed, motion.slide, motion.yaw_rate, motion.cosine,
        motion.sine, motion.tangent, motion.line_heading, motion.acceleration,
    ) = after  # fmt: skip


def line_frames(track: Track, along: Floats) -> Floats:
    """What `poses.line_frames` does of (N,), to the last bit."""
    out = np.empty((5, len(along)))
    frames_kernel()(along, track.first, track.places, track.lines.table, out)
    return out


def looked_up(values: Floats, shift: Integers, track: Track, along: Floats) -> Floats:
    """(N,) the values of the cells at arc lengths; those of an agent are `shift` after those that
    the table of its line has."""
    out = np.empty(len(along))
    lookup_kernel()(values, shift, along, track.first, track.places, out)
    return out


LOADING = 0.5
"""Seconds of processor time that it takes about to load the compiled motion; to compile it, once
after an installation, takes longer."""
PER_STEP, PER_AGENT = 8e-5, 1e-7
"""Seconds of processor time that a step takes about without it, and with each agent more."""
_worked = [0.0]
"""Estimated seconds of this process: it decides which of two motions is used, which are the same to
the last bit."""


def is_loaded() -> bool:
    """Whether the compiled loop is there already."""
    return kernel.cache_info().currsize > 0


def pays(steps: float, agents: int) -> bool:
    """Whether to use the compiled motion for that many steps more: once the work of this process,
    with this, would have paid for loading it."""
    if not is_installed():
        return False
    _worked[0] += steps * (PER_STEP + PER_AGENT * agents)
    return is_loaded() or _worked[0] > LOADING


@cache
def kernel() -> Any:
    """The compiled loop over agents and steps."""
    import numba  # takes half a second, and more where it has to compile
    from numba.extending import register_jitable

    options: dict[str, Any] = {"error_model": "numpy"}  # never `fastmath`: it changes bits
    for formula in (
        vehicle.steered, vehicle.brush, vehicle.demand, vehicle.forces, vehicle.loads,
        vehicle.accelerated, vehicle.walked, vehicle.displaced, vehicle.turned, vehicle.driven,
        vehicle.moved,
    ):  # fmt: skip
        register_jitable(**options)(formula)
    # numba compiles anew when this file changes, but not when `vehicle.py` does: then delete
    # `__pycache__/compiled.*.nbi`.
    return numba.njit(cache=True, nogil=True, **options)(_advanced)


@cache
def frames_kernel() -> Any:
    """The compiled loop over places on lines."""
    import numba
    from numba.extending import register_jitable

    options: dict[str, Any] = {"error_model": "numpy"}
    register_jitable(**options)(lines.on_arc)
    return numba.njit(cache=True, nogil=True, **options)(_framed)


def _framed(along: Any, first: Any, numbers: Any, table: Any, out: Any) -> None:
    """Fill `out`, (5, N)."""
    for i in range(along.shape[0]):
        last, origin, spacing, per_meter = numbers[:, i]
        advance = along[i] - origin
        place = int(np.minimum(np.maximum(advance * per_meter, 0.0), last))
        cell = table[first[i] + place]
        x, y, heading = lines.on_arc(cell, advance - place * spacing, spacing)
        out[0, i], out[1, i], out[2, i], out[3, i], out[4, i] = x, y, heading, cell[6], cell[7]


@cache
def lookup_kernel() -> Any:
    """The compiled loop over values of cells."""
    import numba

    return numba.njit(cache=True, nogil=True, error_model="numpy")(_looked_up)


def _looked_up(
    values: Any, shift: Any, along: Any, first: Any, numbers: Any, out: Any
) -> None:  # fmt: skip
    """Fill `out`, (N,)."""
    for i in range(along.shape[0]):
        last, origin, _, per_meter = numbers[:, i]
        advance = along[i] - origin
        cell = int(np.minimum(np.maximum(advance * per_meter, 0.0), last))
        out[i] = values[shift[i] + first[i] + cell]


def _advanced(
    motions: Any, columns: Any, walks: Any, wanted: Any, places: Any, table: Any, steps: Any,
    dt: Any,
) -> None:  # fmt: skip
    """Fill the second of `motions`, (10, N), from the first, 10 columns."""
    before, after = motions
    first, numbers = places
    for i in range(after.shape[1]):
        s, n, speed = before[0][i], before[1][i], before[2][i]
        slide, yaw_rate, cosine, sine = before[3][i], before[4][i], before[5][i], before[6][i]
        tangent, line, acceleration = before[7][i], before[8][i], before[9][i]
        c = columns[:, i]
        car = (c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[9], c[10])
        last, origin, spacing, per_meter = numbers[:, i]
        advance = s - origin
        cell = int(np.minimum(np.maximum(advance * per_meter, 0.0), last))
        curvature = table[first[i] + cell, 4]
        for _ in range(steps):
            tangent = vehicle.steered(tangent, wanted[0][i], c[11], c[12])
            motion = (speed, slide, yaw_rate)
            if walks[i]:
                found = vehicle.walked(motion, tangent, wanted[1][i], c[0], dt)
            else:
                found = vehicle.driven(motion, tangent, acceleration, wanted[1][i], car, dt)
            speeds = (speed, found[0], found[1])
            speed, slide, yaw_rate, acceleration = found
            s, n = vehicle.moved((s, n), speeds, (cosine, sine), curvature, dt)
            advance = s - origin
            cell = int(np.minimum(np.maximum(advance * per_meter, 0.0), last))
            curvature = table[first[i] + cell, 4]
            heading = table[first[i] + cell, 5] + curvature * (advance - cell * spacing)
            angle = yaw_rate * dt - (heading - line)
            cosine, sine = vehicle.turned(cosine, sine, angle)
            line = heading
        after[0, i], after[1, i], after[2, i], after[3, i] = s, n, speed, slide
        after[4, i], after[5, i], after[6, i], after[7, i] = yaw_rate, cosine, sine, tangent
        after[8, i], after[9, i] = line, acceleration
