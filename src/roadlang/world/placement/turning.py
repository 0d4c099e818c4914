"""How sharply vehicles can turn."""

from __future__ import annotations

import math

SWEPT = 2.6
"""Meters to each side of the middle of a lane that what turns may sweep, at most: from there on it
is in the way of those in the next lane."""
TOLERANCE = 1.03
"""A turn may be so much sharper than a vehicle can steer: it is short."""


def sharpest_turn(kind: object) -> float:
    """1/m: the greatest curvature of the path of the middle of a vehicle that it can steer, and on
    which it stays within its lane; infinite for a kind without such sizes.

    With the wheelbase `b` and steering angle `d` the middle between the axles is on a circle of
    radius `sqrt((b / tan d)^2 + b^2 / 4)`. The corners of a vehicle of length `l` and width `w`
    whose middle is on a circle of radius `r` are about `l^2 / (8 r) + w / 2` outside of it.
    """
    found = (getattr(kind, name, None) for name in ("length", "width", "wheelbase", "max_steering"))
    numbers = [float(number) for number in found if isinstance(number, int | float)]
    if len(numbers) != 4:
        return math.inf
    length, width, base, angle = numbers
    rear = base / math.tan(angle) if angle > 0.0 else math.inf
    steered = TOLERANCE / math.hypot(rear, 0.5 * base) if rear or base else math.inf
    swept = max(0.0, 8.0 * (SWEPT - 0.5 * width) / (length * length))
    return min(steered, swept)
