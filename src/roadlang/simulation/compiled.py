"""The same motion, compiled by numba where that is installed: the same formulas, the same bits."""

from __future__ import annotations

import importlib.util
from functools import cache
from typing import Any

import numpy as np

from ..geometry.arrays import Floats
from . import vehicle
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
    state = np.stack(
        (
            motion.along, motion.offset, motion.speed, motion.slide, motion.yaw_rate,
            motion.cosine, motion.sine, motion.tangent, motion.line_heading, motion.acceleration,
        )
    )  # fmt: skip
    columns = np.stack((*car.columns, car.lag, car.rate, *wanted))
    places = np.stack((track.last, track.origin, track.spacing, track.per_meter))
    lines = (track.lines.heading, track.lines.curvature)
    kernel()(state, columns, places, track.first, car.walks, lines, steps, dt)
    (
        motion.along, motion.offset, motion.speed, motion.slide, motion.yaw_rate,
        motion.cosine, motion.sine, motion.tangent, motion.line_heading, motion.acceleration,
    ) = state  # fmt: skip


def is_loaded() -> bool:
    """Whether the compiled loop is there already."""
    return kernel.cache_info().currsize > 0


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
    return numba.njit(cache=True, nogil=True, **options)(_advanced)


def _advanced(
    state: Any, columns: Any, places: Any, first: Any, walks: Any, lines: Any, steps: Any, dt: Any
) -> None:
    """Change `state` (10, N) in place."""
    headings, curvatures = lines
    for i in range(state.shape[1]):
        s, n, speed, slide, yaw_rate, cosine, sine, tangent, line, before = state[:, i]
        c = columns[:, i]
        car = (c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[9], c[10])
        last, origin, spacing, per_meter = places[:, i]
        gone = s - origin
        cell = int(np.minimum(np.maximum(gone * per_meter, 0.0), last))
        curvature = curvatures[first[i] + cell]
        for _ in range(steps):
            tangent = vehicle.steered(tangent, c[13], c[11], c[12])
            motion = (speed, slide, yaw_rate)
            if walks[i]:
                after = vehicle.walked(motion, tangent, c[14], c[0], dt)
            else:
                after = vehicle.driven(motion, tangent, before, c[14], car, dt)
            speeds = (speed, after[0], after[1])
            speed, slide, yaw_rate, before = after
            s, n = vehicle.moved((s, n), speeds, (cosine, sine), curvature, dt)
            gone = s - origin
            cell = int(np.minimum(np.maximum(gone * per_meter, 0.0), last))
            curvature = curvatures[first[i] + cell]
            heading = headings[first[i] + cell] + curvature * (gone - cell * spacing)
            angle = yaw_rate * dt - (heading - line)
            cosine, sine = vehicle.turned(cosine, sine, angle)
            line = heading
        state[0, i], state[1, i], state[2, i], state[3, i] = s, n, speed, slide
        state[4, i], state[5, i], state[6, i], state[7, i] = yaw_rate, cosine, sine, tangent
        state[8, i], state[9, i] = line, before
