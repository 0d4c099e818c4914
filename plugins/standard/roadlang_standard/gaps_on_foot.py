"""Gaps in traffic for who crosses on foot."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from roadlang.api import ObservationBatch
    from roadlang.geometry import Booleans, Floats

VIEW = 80.0
"""Meters within which vehicles are looked at."""
STEP, LONGEST = 0.25, 30.0
"""Seconds from one moment that is looked at to the next, and of the longest way."""
SHORTEST = 1.5
"""Meters: anything shorter does not count as a vehicle."""
MOVES = 0.5
"""m/s: what is slower waits, or lets one pass."""
ASIDE, BEHIND = 0.7, 0.5
"""Meters between a vehicle and who passes beside it or behind it, at least."""
BEFORE = 1.2
"""Seconds between somebody who passes before a vehicle and the vehicle, at least."""


def has_gap(seen: ObservationBatch, heading: Floats, length: Floats, speed: Floats) -> Booleans:
    """(N,) whether no vehicle comes near who walks `length` (N,) meters straight on in the
    direction `heading` (N,) at `speed` (N,), if all vehicles go on as they move now."""
    import numpy as np

    near = seen.nearby(VIEW)
    counts = near.there & (near.length > SHORTEST) & (near.speed > MOVES)
    if not counts.any():
        return np.ones(len(heading), dtype=bool)
    length, speed = length[:, None], speed[:, None]
    longest = min(float(np.max(length / speed, initial=0.0)), LONGEST)
    times = np.arange(0.0, longest + STEP, STEP)[:, None, None]
    walked = np.minimum(speed * times, length)
    x = (seen.x[:, None] - near.x) + walked * np.cos(heading)[:, None]
    y = (seen.y[:, None] - near.y) + walked * np.sin(heading)[:, None]
    cosine, sine = np.cos(near.heading), np.sin(near.heading)
    ahead = cosine * x + sine * y - near.speed * times
    across = np.abs(cosine * y - sine * x)
    before = 0.5 * near.length + BEFORE * near.speed
    close = (ahead > -0.5 * near.length - BEHIND) & (ahead < before)
    close &= across < 0.5 * near.width + ASIDE
    walking = speed * times <= length + speed * STEP
    return np.asarray(~(close & walking & counts).any(axis=(0, 2)))
