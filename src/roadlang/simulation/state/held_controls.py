"""What agents do while they hold what is decided: within what they can steer, with the braking of
those who stand or have arrived; compiled where the motion is, to the same bits."""

from __future__ import annotations

import math
import sys
from functools import cache
from typing import Any, Protocol

import numpy as np

from ...geometry.arrays import Booleans, Floats
from ..lines.route_table import RouteTable
from ..vehicles import compiled
from ..vehicles.bodies import Bodies
from ..vehicles.motion import Advance, Motion, Track
from ..vehicles.verges import Verges
from . import arrivals
from .arrivals import END_BRAKING


class DrivenWorld(Protocol):
    """What has to be known of a `World` here."""

    bodies: Bodies
    motion: Motion
    verges: Verges
    table: RouteTable
    track: Track
    present: Booleans
    halted: Booleans

    @property
    def advance(self) -> Advance:
        """The equations of motion."""

    @property
    def at_end(self) -> Booleans:
        """(N,) who has arrived."""


def held_controls(
    world: DrivenWorld, steering: Floats, acceleration: Floats
) -> tuple[tuple[Floats, Floats], Bodies]:
    """(N,) tangents of the steering angle and accelerations; and the bodies with the grip that they
    have where they are."""
    bodies, motion = world.bodies, world.motion
    if world.advance is not compiled.advance or world.track.has_closed:
        wanted, stand = limited(world, acceleration), np.count_nonzero(world.halted)
        held = np.where(world.halted, -END_BRAKING, wanted) if stand else wanted
        below = world.verges.below(bodies, motion, world.table, world.present)
        return (tangents(bodies, steering), held), below
    out = np.empty((2, len(steering)))
    may_leave = _loop()(
        (steering, acceleration), (bodies.least_steering, bodies.max_steering, bodies.half_base),
        (motion.offset, motion.sine, world.verges.clear), (world.at_end, world.halted), out,
    )  # fmt: skip
    if may_leave or not world.verges.patches.is_empty:
        bodies = world.verges.below(bodies, motion, world.table, world.present)
    return (np.tan(out[0]), out[1]), bodies


def tangents(bodies: Bodies, steering: Floats) -> Floats:
    """(N,) of the steering angles, within what agents can steer."""
    angle = np.minimum(np.maximum(steering, bodies.least_steering), bodies.max_steering)
    found: Floats = np.tan(angle)  # of traced columns too
    return found


def limited(world: DrivenWorld, acceleration: Floats) -> Floats:
    """(N,) accelerations with the braking of those who have arrived at the end of a road."""
    if not np.count_nonzero(world.at_end):  # several times as fast as `any`
        return acceleration
    most = np.where(world.at_end & ~world.track.closed, -END_BRAKING, math.inf)
    return np.minimum(acceleration, most)


def loop_over_controls(wanted: Any, limits: Any, places: Any, flags: Any, out: Any) -> Any:
    """Fill `out`, (2, N), with steering angles and accelerations. Whether anybody may have a wheel
    beside the road. numba compiles it; Python never runs it."""
    (steering, acceleration), (least, most, half_base) = wanted, limits
    (offset, sine, clear), (at_end, halted) = places, flags
    may_leave = False
    for i in range(out.shape[1]):
        angle = steering[i] if steering[i] > least[i] else least[i]
        out[0, i], held = angle if angle < most[i] else most[i], acceleration[i]
        if halted[i] or (at_end[i] and not held < -arrivals.END_BRAKING):
            held = -arrivals.END_BRAKING
        out[1, i] = held
        may_leave = may_leave or abs(offset[i]) + half_base[i] * abs(sine[i]) > clear[i]
    return may_leave


@cache
def _loop() -> Any:
    compiled.register((), (loop_over_controls,))
    return compiled.compile_loop(loop_over_controls, sys.modules[__name__], arrivals)
