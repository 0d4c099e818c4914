"""Places on different levels: whether two can meet."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Booleans

HEADROOM = 3.0
"""Meters between two roads of which one passes above the other, at least."""
STEEPEST = 0.12
"""No road is steeper over a long way: the farther two are from each other, the more one may be
above the other on the same hill."""


def are_apart(height: ArrayLike, other: ArrayLike, away: ArrayLike = 0.0) -> Booleans:
    """Whether two are on different levels, so that they cannot meet: elementwise, of heights in
    meters and the distance between them in the plane. Where a height is not known (NaN), False."""
    apart = np.abs(np.asarray(height) - np.asarray(other))
    return np.asarray(apart > HEADROOM + STEEPEST * np.asarray(away))
