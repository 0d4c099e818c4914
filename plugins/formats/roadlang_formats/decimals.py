"""Numbers as text with a fixed number of decimals, alike on every machine."""

from __future__ import annotations

import math


def decimals(value: float, digits: int) -> str:
    """`0.000`, never `-0.000`: which side of zero what is nothing falls on is rounding."""
    return f"{round(value, digits) + 0.0:.{digits}f}"


def bearing(heading: float, digits: int) -> float:
    """Degrees clockwise from north, in [0, 360), of a heading in radians counterclockwise from
    east."""
    return round((90.0 - math.degrees(heading)) % 360.0, digits) % 360.0
