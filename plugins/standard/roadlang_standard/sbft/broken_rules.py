"""The rules of the competition that a road breaks, in words."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .rules import HALF_WIDTH, LEAST_LENGTH, LEAST_RADIUS, MOST_POINTS, judged

Floats = NDArray[np.float64]


def broken_rules(points: Floats, size: float, centered: bool) -> str | None:
    """What is wrong with one road (1, n, 2) in a map of `size` meters; None if nothing is.

    `centered`: as in `road_points`.
    """
    count = points.shape[1]
    if count > MOST_POINTS:
        return f"it has {count} points, but at most {MOST_POINTS} are allowed: increase `spacing`"
    margins = judged(points, size)
    inside, apart, radius, length = (
        float(column[0])
        for column in (margins.inside, margins.apart, margins.radius, margins.length)
    )
    found = []
    if inside < 0.0:
        where = "" if centered else "; `centered: true` moves it to the middle of the map"
        found.append(
            f"the road, {2.0 * HALF_WIDTH:g} m wide, leaves the map of {size:g} m by {size:g} m "
            f"by {_meters(-inside)}{where}"
        )
    if radius < 0.0:
        found.append(
            f"its minimum radius is {_meters(LEAST_RADIUS + radius)}; at least "
            f"{LEAST_RADIUS:.2f} m is required"
        )
    if apart < 0.0 <= radius:  # a sharp bend folds as well
        found.append("parts of it overlap or touch")
    if length < 0.0:
        found.append(
            f"it is {_meters(LEAST_LENGTH + length)} long; at least {LEAST_LENGTH:g} m is required"
        )
    return "; ".join(found) or None


def _meters(value: float) -> str:
    return f"{value:.3g} m"
