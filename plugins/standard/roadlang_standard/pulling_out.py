"""Pulling out from behind what stands still: how far away to wait, and how to begin."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .passing import STANDSTILL
from .steering import pursuit, toward

if TYPE_CHECKING:
    from roadlang.api import ObservationBatch
    from roadlang.geometry import Booleans, Floats

PULL_OUT = 8.0
"""Meters before something that stands still at which it waits, so that it can pull out."""
QUEUE = 5.0
"""m/s: what is slower may be about to stand still."""
EASE = 1.5
"""m/s^2: from this deceleration on it brakes for what stands still."""
BACK_OFF = 6.0
"""m/s^2: deceleration of who gives up, at most."""
TIGHTEST = 2.7
"""Meters: from less behind something that stands still nobody can pull out."""
CLEARED = 0.65
"""Share of the time of a lane change after which it is clear of what it passes."""
CREEPING = 1.5
"""m/s at which it pulls out from close behind, with the wheels turned as far as they go."""
SLOWEST, TURNED = 0.4, 0.1
"""m/s until it has turned by so many radians: its wheels turn before it moves."""
LOOKAHEAD = 3.0
"""Meters on to which it steers then."""


def held_back(seen: ObservationBatch, gap: Floats, pace: Floats, waits: Booleans) -> Floats:
    """(N,) acceleration of who `waits` behind something that stands still, or soon may, where it
    can still pull out; `gap` and `pace` are of what is ahead. NaN for who need not brake."""
    import numpy as np

    waits = waits & (pace < QUEUE) & (gap > 0.0)
    pace = np.where(pace < STANDSTILL, 0.0, pace)
    closing = np.maximum(seen.speed * seen.speed - pace * pace, 0.0)
    needed = closing / (2.0 * np.maximum(gap - PULL_OUT, 0.1))
    close = (gap < PULL_OUT + 0.5) & (seen.speed > 0.5 * pace)
    needed = np.where(close, np.maximum(needed, 2.0 * EASE), needed)
    return np.where(waits & (needed > EASE), -np.minimum(needed, BACK_OFF), np.nan)


def can_creep_out(seen: ObservationBatch, gap: Floats, aside: Floats | float = 0.0) -> Booleans:
    """(N,) who is slow and far enough behind what stands `gap` meters ahead; who is `aside` meters
    on its way already needs less."""
    return (gap > TIGHTEST - aside) & (seen.speed < 2.0 * CREEPING)


def creeping_out(seen: ObservationBatch, acceleration: Floats | float) -> tuple[Floats, Floats]:
    """(N,) steering and acceleration of who pulls out from close behind something: `acceleration`
    at most."""
    import numpy as np

    turned = np.abs(seen.heading_error) > TURNED
    pace = np.where(turned, CREEPING, SLOWEST)
    return pursuit(seen, LOOKAHEAD), toward(seen.speed, pace, acceleration, BACK_OFF)
