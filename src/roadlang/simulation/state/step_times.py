"""Times of steps."""

from __future__ import annotations

from functools import lru_cache


@lru_cache(1024)
def seconds_at(tick: int, dt: float) -> float:
    """Seconds since the start at a step, as one would write them: 0.3, not 0.30000000000000004.
    Rounding takes a microsecond, and every step asks several times."""
    return round(tick * dt, 9)
