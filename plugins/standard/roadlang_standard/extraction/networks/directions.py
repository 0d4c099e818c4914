"""In which direction traffic runs on roads whose legend says so."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..curves.smoothing import resample
from .found_network import FoundRoad

_STEP = 0.5
"""Distance in pixels between the points at which the direction is read."""
_SHARE = 0.5
"""A road is one-way if the lengths that run each way differ by at least this share of its
length."""


def runs_forward(road: FoundRoad, directions: NDArray[np.float64] | None) -> bool | None:
    """Whether traffic runs from the start of a road to its end; None where it runs both ways.

    `directions` (h, w, 2) are the directions of pixels, y down, zero where none is said.
    """
    if directions is None or len(road.points) < 2 or road.length <= 0.0:
        return None
    points = resample(road.points, _STEP)
    steps = np.diff(points, axis=0)
    middles = np.rint((points[1:] + points[:-1]) / 2.0).astype(int)
    x = np.clip(middles[:, 0], 0, directions.shape[1] - 1)
    y = np.clip(middles[:, 1], 0, directions.shape[0] - 1)
    along = float((steps * directions[y, x]).sum())
    return along > 0.0 if abs(along) >= _SHARE * road.length else None
