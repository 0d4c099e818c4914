"""Pulling out from behind a standing vehicle or object: where to wait, and how to begin."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .passing import STANDSTILL
from .steering import pursuit, toward

if TYPE_CHECKING:
    from roadlang.api import ObservationBatch
    from roadlang.geometry import Booleans, Floats

PULL_OUT = 8.0
"""Meters behind a standing vehicle or object at which a vehicle waits, so that it can pull out."""
QUEUE = 5.0
"""m/s: a slower vehicle ahead counts as one that may stop."""
EASE = 1.5
"""m/s^2: braking begins when stopping in time needs at least this deceleration."""
BACK_OFF = 6.0
"""m/s^2: the maximum deceleration of a vehicle that stops behind it."""
TIGHTEST = 2.7
"""Meters: with a smaller gap ahead no vehicle can pull out."""
CLEARED = 0.65
"""Share of the duration of a lane change after which a vehicle no longer overlaps the lane that it
leaves."""
CREEPING = 1.5
"""m/s: the speed of pulling out from close behind, with the front wheels fully turned."""
SLOWEST, TURNED = 0.4, 0.1
"""m/s, and radians: until its heading has changed by so much, it moves at most this fast, so that
the front wheels turn first."""
LOOKAHEAD = 3.0
"""Meters: the lookahead distance while it pulls out."""


def held_back(seen: ObservationBatch, gap: Floats, pace: Floats, waits: Booleans) -> Floats:
    """(N,) accelerations of the vehicles in `waits` that must stop behind a standing vehicle or
    object, or one that may stop, with enough distance to pull out; NaN for those that need not
    brake. `gap` and `pace`: distance to what is ahead, and its speed."""
    import numpy as np

    waits = waits & (pace < QUEUE) & (gap > 0.0)
    pace = np.where(pace < STANDSTILL, 0.0, pace)
    closing = np.maximum(seen.speed * seen.speed - pace * pace, 0.0)
    needed = closing / (2.0 * np.maximum(gap - PULL_OUT, 0.1))
    close = (gap < PULL_OUT + 0.5) & (seen.speed > 0.5 * pace)
    needed = np.where(close, np.maximum(needed, 2.0 * EASE), needed)
    return np.where(waits & (needed > EASE), -np.minimum(needed, BACK_OFF), np.nan)


def can_creep_out(seen: ObservationBatch, gap: Floats, aside: Floats | float = 0.0) -> Booleans:
    """(N,) which vehicles are slow enough, and far enough behind what stands `gap` meters ahead, to
    pull out; one that is already displaced by `aside` meters needs a smaller gap."""
    return (gap > TIGHTEST - aside) & (seen.speed < 2.0 * CREEPING)


def creeping_out(seen: ObservationBatch, acceleration: Floats | float) -> tuple[Floats, Floats]:
    """(N,) steering angles and accelerations, at most `acceleration`, of vehicles that pull out
    from close behind a standing vehicle or object."""
    import numpy as np

    turned = np.abs(seen.heading_error) > TURNED
    pace = np.where(turned, CREEPING, SLOWEST)
    return pursuit(seen, LOOKAHEAD), toward(seen.speed, pace, acceleration, BACK_OFF)
