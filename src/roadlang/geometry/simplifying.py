"""Lines with fewer points that look the same."""

from __future__ import annotations

import numpy as np

from .arrays import Floats, Integers


def simplified(points: Floats, tolerance: float) -> Integers:
    """Indices of the points (n, 2) of a line that stays within `tolerance` of all of them (Ramer
    1972; Douglas and Peucker 1973)."""
    selected = np.zeros(len(points), dtype=bool)
    selected[[0, -1]] = True
    open_ = [(0, len(points) - 1)]
    while open_:
        first, last = open_.pop()
        if last - first < 2:
            continue
        inner = points[first + 1 : last] - points[first]
        chord = points[last] - points[first]
        length = float(np.hypot(*chord))
        if length > 0.0:
            gaps = np.abs(inner[:, 0] * chord[1] - inner[:, 1] * chord[0]) / length
        else:
            gaps = np.hypot(inner[:, 0], inner[:, 1])
        farthest = int(np.argmax(gaps))
        if gaps[farthest] > tolerance:
            middle = first + 1 + farthest
            selected[middle] = True
            open_ += [(first, middle), (middle, last)]
    return np.flatnonzero(selected)
