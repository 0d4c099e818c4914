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
        return f"it has {count} points, and {MOST_POINTS} are the most: give it a larger `spacing`"
    margins = judged(points, size)
    inside, apart, radius, length = (
        float(column[0])
        for column in (margins.inside, margins.apart, margins.radius, margins.length)
    )
    found = []
    if inside < 0.0:
        where = "" if centered else "; `centered: true` moves it to the middle of the map"
        found.append(
            f"the road, {2.0 * HALF_WIDTH:g} m wide, sticks out of the map of {size:g} m by "
            f"{size:g} m, by {_meters(-inside)}{where}"
        )
    if radius < 0.0:
        found.append(
            f"its least radius is {_meters(LEAST_RADIUS + radius)}, and {LEAST_RADIUS:.2f} m the "
            "least allowed"
        )
    if apart < 0.0 <= radius:  # a sharp bend folds as well
        found.append("parts of it overlap or touch")
    if length < 0.0:
        found.append(f"it is {_meters(LEAST_LENGTH + length)} long, not {LEAST_LENGTH:g} m")
    return "; ".join(found) or None


def _meters(value: float) -> str:
    return f"{value:.3g} m"
