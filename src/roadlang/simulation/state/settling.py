"""What becomes of agents that have moved for some steps, compiled where the motion is: the same as
`World._arrive` on open lines, to the last bit."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from functools import cache
from typing import Any, Protocol

import numpy as np

from ...geometry.arrays import Booleans, Floats
from ..junctions.stop_lines import StopLines
from ..lines.followed_lines import FollowedLines
from ..vehicles import compiled
from ..vehicles.bodies import Bodies
from ..vehicles.motion import Advance, Motion, Track
from ..vehicles.placing import Placing
from . import arrivals

MOTION, ROWS, FLAGS = 10, 15, 3
"""Columns of a motion, of which who has left gets all back; rows of numbers and of truths that the
loop fills."""


class MovingWorld(Protocol):
    """What has to be known of a `World` here."""

    placing: Placing | None
    track: Track
    dt: float
    tick: int
    bodies: Bodies
    motion: Motion
    followed: FollowedLines
    stop_lines: StopLines
    filled: Booleans
    present: Booleans
    has_road: Booleans
    any_left: bool
    end: Floats
    traveled: Floats
    pace: tuple[Floats, Floats]
    arrived: tuple[Floats, Floats, Booleans] | None

    @property
    def advance(self) -> Advance:
        """The equations of motion."""

    def count_red_lights(self, before: Floats, moved: Floats, seconds: float) -> None:
        """Agents have `moved` from arc lengths `before`."""


def can_settle(world: MovingWorld) -> bool:
    """Whether the loop is written for what moves in a world: vehicles on open lines."""
    is_compiled = world.advance is compiled.advance
    return is_compiled and world.placing is None and not world.track.has_closed


def settle(world: MovingWorld, before: Motion, steps: int) -> None:
    """The motion of a world is `steps` steps on; `before`: what it was then."""
    seconds = steps * world.dt
    found = settled(
        world.motion, before, (world.filled, world.present, world.has_road),
        (world.end, world.traveled, world.bodies.length, world.stop_lines.along), world.any_left,
        seconds,
    )  # fmt: skip
    world.pace, world.traveled = found.pace, found.traveled
    world.followed.advance(found.speed, seconds)
    if found.crosses:
        world.count_red_lights(before.along, found.moved, seconds)
    world.tick += steps
    world.arrived = world.motion.along, world.traveled, found.at_end
    world.any_left, world.present = found.any_left, found.present


@dataclass(frozen=True)
class Settled:
    """Where agents (N,) are at the end of some steps."""

    pace: tuple[Floats, Floats]
    traveled: Floats
    moved: Floats
    """meters along the lines"""
    speed: Floats
    """m/s; 0 of who has left"""
    at_end: Booleans
    present: Booleans
    crosses: bool
    """whether anybody crosses a stop line with a signal"""
    any_left: bool
    """whether anybody is not present any more"""


def settled(
    motion: Motion,
    before: Motion,
    agents: tuple[Booleans, Booleans, Booleans],
    lines: tuple[Floats, Floats, Floats, Floats],
    any_left: bool,
    seconds: float,
) -> Settled:
    """Who has left goes no further: `motion` is changed. `before`: what it was `seconds` ago.
    `agents` (N,): who is filled, was present, and has a road; `lines`: (N,) where they end, how far
    agents had traveled, their lengths, and (N, X) their stop lines; `any_left`: whether anybody of
    who was not present had left."""
    out = np.empty((ROWS, len(motion.along)))
    truths = np.empty((FLAGS, len(motion.along)), dtype=bool)
    crosses, any_left = _loop()(
        before.columns, motion.columns, agents, lines, any_left, seconds, out, truths
    )
    (
        motion.along, motion.offset, motion.speed, motion.slide, motion.yaw_rate, motion.cosine,
        motion.sine, motion.tangent, motion.line_heading, motion.acceleration,
        along, left, traveled, moved, speed,
    ) = out  # fmt: skip
    at_end, _, present = truths
    return Settled((along, left), traveled, moved, speed, at_end, present, crosses, any_left)


def loop_over_moved(
    before: Any, after: Any, agents: Any, lines: Any, any_left: Any, seconds: Any, out: Any,
    truths: Any,
) -> Any:  # fmt: skip
    """Fill `out`, (15, N), with ten columns of the motion, the pace along and to the left, and
    `traveled`, `moved` and `speed` of `Settled`, and `truths`, (3, N), with `at_end`, who of these
    did not begin there, and `present`. Whether anybody crosses a stop line, and whether anybody has
    left. numba compiles it; Python never runs it."""
    (filled, present, has_road), (end, traveled, length, stops) = agents, lines
    crosses, any_at_end = False, False
    for i in range(out.shape[1]):
        gone = any_left and filled[i] and not present[i] and has_road[i]
        gone = gone and end[i] - after[0][i] < arrivals.ARRIVED
        for k in range(10):
            out[k, i] = before[k][i] if gone else after[k][i]
        moved = out[0, i] - before[0][i]
        out[10, i], out[11, i] = moved / seconds, (out[1, i] - before[1][i]) / seconds
        out[12, i], out[13, i] = traveled[i] + moved, moved
        out[14, i] = 0.0 if gone else after[2][i]
        front = before[0][i] + 0.5 * length[i]
        for x in range(stops.shape[1]):
            ahead = stops[i, x] - front
            crosses = crosses or (ahead > 0.0 and ahead <= moved)
        at_end = has_road[i] and end[i] - out[0, i] < arrivals.ARRIVED
        truths[0, i], truths[1, i] = at_end, at_end and out[12, i] > arrivals.ARRIVED
        truths[2, i] = present[i]
        any_at_end = any_at_end or at_end
    has_left = False
    if any_left or any_at_end:
        for i in range(out.shape[1]):
            truths[2, i] = filled[i] and not truths[1, i]
            has_left = has_left or truths[1, i]
    return crosses, has_left


@cache
def _loop() -> Any:
    compiled.register((), (loop_over_moved,))
    return compiled.compile_loop(loop_over_moved, sys.modules[__name__], arrivals)
