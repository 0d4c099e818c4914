"""Distances of points from rings, such as the areas of junctions."""

from __future__ import annotations

import numpy as np

from ..arrays import Floats


def outside_ring(ring: Floats, x: Floats, y: Floats) -> Floats:
    """(...) meters from points to the edge of a simple polygon `ring` (m, 2); negative inside.

    A point is inside where a ray from it to the east crosses the edge an odd number of times.
    """
    begin, end = ring, np.roll(ring, -1, axis=0)
    px, py = x[..., None], y[..., None]
    step_x, step_y = end[:, 0] - begin[:, 0], end[:, 1] - begin[:, 1]
    off_x, off_y = px - begin[:, 0], py - begin[:, 1]
    square = step_x * step_x + step_y * step_y
    share = (off_x * step_x + off_y * step_y) / np.where(square > 0.0, square, 1.0)
    share = np.minimum(np.maximum(share, 0.0), 1.0)
    away_x, away_y = off_x - share * step_x, off_y - share * step_y
    away = np.sqrt((away_x * away_x + away_y * away_y).min(axis=-1))
    spans = (begin[:, 1] > py) != (end[:, 1] > py)
    at = off_y * step_x / np.where(step_y != 0.0, step_y, 1.0)
    crossings = (spans & (off_x < at)).sum(axis=-1)
    return np.asarray(np.where(crossings % 2 == 1, -away, away))
