"""The units of speed in which maps write limits."""

from __future__ import annotations

KMH, MPH = 1.0 / 3.6, 0.44704
"""m/s in one km/h, and in one mile per hour."""


def in_kmh(speed: float) -> str:
    """m/s as km/h: `50`, `48.2803`."""
    return f"{speed * 3.6:.6g}"
