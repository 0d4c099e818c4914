"""Gaps in traffic for who crosses on foot, and vehicles that are in its way."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from roadlang.api import ObservationBatch
    from roadlang.geometry import Booleans, Floats

VIEW = 80.0
"""Meters within which vehicles are looked at."""
STEP, LONGEST = 0.25, 30.0
"""Seconds from one moment that is looked at to the next, and of the longest way."""
MOVES = 0.5
"""m/s: what is slower waits, or lets one pass."""
ASIDE, BEHIND = 0.7, 0.5
"""Meters between a vehicle and who passes beside it or behind it, at least."""
BEFORE = 1.2
"""Seconds between somebody who passes before a vehicle and the vehicle, at least."""
AHEAD, NEAR = 1.0, 20.0
"""Meters ahead in which nobody walks into the side of a vehicle, and within which the middle of one
is seen, a tram too."""
SHORTEST = 1.0
"""Meters: who walks steps over anything shorter that stands."""
STANDS = 0.1
"""m/s: who walks goes round what is slower."""


def has_gap(seen: ObservationBatch, heading: Floats, length: Floats, speed: Floats) -> Booleans:
    """(N,) whether no vehicle comes near who walks `length` (N,) meters straight on in the
    direction `heading` (N,) at `speed` (N,), if all vehicles go on as they move now."""
    import numpy as np

    near = seen.nearby(VIEW)
    counts = near.there & ~near.walks & (near.speed > MOVES)
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


def blocked_by_vehicle(seen: ObservationBatch, heading: Floats) -> tuple[Booleans, Floats]:
    """(N,) whether the next step would lead into a vehicle that is there already, and if that
    stands, the direction along it to its nearer end, else NaN."""
    import numpy as np

    near = seen.nearby(NEAR)
    ahead = 0.5 * seen.length + AHEAD
    off_x = (seen.x + ahead * np.cos(heading))[:, None] - near.x
    off_y = (seen.y + ahead * np.sin(heading))[:, None] - near.y
    cosine, sine = np.cos(near.heading), np.sin(near.heading)
    along, across = cosine * off_x + sine * off_y, cosine * off_y - sine * off_x
    beside = 0.5 * seen.width[:, None]
    inside = np.abs(along) < 0.5 * near.length + beside
    inside &= np.abs(across) < 0.5 * near.width + beside
    inside &= near.there & ~near.walks & (near.length > SHORTEST)
    blocked = np.asarray(inside.any(axis=1))
    if not blocked.any():
        return blocked, np.full(len(heading), np.nan)
    first, each = inside.argmax(axis=1), np.arange(len(heading))
    onward = near.heading[each, first] + np.where(along[each, first] < 0.0, np.pi, 0.0)
    stands = (inside & (near.speed < STANDS)).sum(axis=1) == inside.sum(axis=1)
    return blocked, np.where(blocked & stands, onward, np.nan)
