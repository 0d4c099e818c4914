"""Agents on the way to junctions: how far they are, and what signals demand of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..junctions.crossings import STOP_GAP
from ..state.world import World
from .entrants import Ways

COMFORTABLE = 3.2
"""m/s^2: who would have to brake harder for a yellow light may go on, ..."""
IN_TIME = 0.85
"""... if it reaches the line within this share of the time until red; else it brakes, ..."""
HARDEST = 7.0
"""... unless it would have to brake harder than this, m/s^2."""
WARNING = 3.0
"""Seconds before red from which on cars decide whether to stop, if yellow is shorter."""
SIGN_SPEED, SIGN_DISTANCE = 0.09, 3.5
"""An agent that was slower than this, in m/s, within this many meters of a stop line has stopped
there."""
FAR = 1e6
"""Seconds: no signal lasts longer."""
OVER_LINE = 1.0
"""Meters over a stop line within which a car may still wait."""
LEAST_DISTANCE = 0.05
"""Meters in which who is at a line or over it would have to stop, for want of any."""


@dataclass(frozen=True)
class Approaches:
    """Arrays (N, X): the crossings of some agents as they are now."""

    to_line: Floats
    """meters from the front to the stop line, negative beyond it; infinite for no crossing"""
    to_leave: Floats
    """meters until the rear has left the connection, negative beyond"""
    number: Integers
    """of the connection, through all junctions"""
    may_go: Booleans
    """as far as signals are concerned"""
    must_stop: Booleans
    """because of its signal, although it was let go"""
    is_over: Booleans
    """the rear has left it, or there is none"""
    is_behind: Booleans
    """it is over, or comes only in the next lap"""

    @classmethod
    def of(cls, world: World, ways: Ways) -> Approaches:
        """Of the agents whose crossings these are."""
        rows, none = ways.rows, ways.none
        along = world.motion.along[rows, None]
        to_line = ways.crossings.stop - along - ways.half
        to_leave = ways.crossings.exit - along + ways.half
        is_over = none | (to_leave < 0.0)
        is_behind = is_over
        if world.track.has_closed:
            closed, length = world.closed[rows, None], world.length[rows, None]
            counts = closed & ~none  # a rear still inside has not passed the seam of the lap
            lap = np.floor(np.where(counts, to_leave, 0.0) / length) * length
            to_line, to_leave = to_line - lap, to_leave - lap
            is_over = none | (is_over & ~closed)
            is_behind = is_over | (closed & (to_line > 0.5 * world.length[rows, None]))
        green, to_red = ways.lights.at(world.age[rows, None])
        speed = world.motion.speed[rows, None]
        needed = braking_to_stop(speed, to_line - STOP_GAP)
        left = np.minimum(to_red, FAR)
        ends = ~green | (to_red < WARNING)
        in_time = (needed > COMFORTABLE) & (to_line < IN_TIME * speed * left)
        may_go = ~ends | in_time
        must_stop = ~may_go & (needed < HARDEST) & (to_line >= 0.0)
        return cls(to_line, to_leave, ways.number, may_go, must_stop, is_over, is_behind)


def braking_to_stop(speed: Floats, distance: Floats) -> Floats:
    """m/s^2 with which to stop within a distance: v^2 / (2 d)."""
    return np.asarray(0.5 * speed * speed / np.maximum(distance, LEAST_DISTANCE))


def seconds_for(
    distance: Floats, speed: Floats, acceleration: float, fastest: Floats | float
) -> Floats:
    """How long a distance takes with an acceleration until `fastest`; 0 for what lies behind."""
    speed = np.maximum(speed, 0.0)
    top = np.maximum(speed, fastest)
    span = (top - speed) / acceleration
    gained = 0.5 * (speed + top) * span
    distance = np.maximum(distance, 0.0)
    rising = (np.sqrt(speed * speed + 2.0 * acceleration * distance) - speed) / acceleration
    return np.asarray(np.where(distance < gained, rising, span + (distance - gained) / top))


def horizon(speed: Any, seconds: Any) -> Any:
    """Meters before a junction from which on a car asks to go: it could still stop. Of columns, and
    of numbers in the compiled loop."""
    return speed * seconds + speed * speed / 6.0 + 6.0
