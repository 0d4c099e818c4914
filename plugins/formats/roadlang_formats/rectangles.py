"""The smallest rectangles around outlines, such as those of buildings."""

from __future__ import annotations

import math

import numpy as np

from roadlang.geometry import Floats

Rectangle = tuple[float, float, float, float, float]


def smallest_rectangle(corners: Floats) -> Rectangle:
    """Of the rectangles around corners (n, 2) that with the smallest area: x and y of its center,
    its length along and its width across the heading, and the heading. It lies along one of the
    sides of their convex hull."""
    corners = _outermost(corners)
    best = (math.inf, 0.0, np.zeros(2), np.zeros(2))
    for side in np.roll(corners, -1, axis=0) - corners:
        heading = math.atan2(float(side[1]), float(side[0]))
        cosine, sine = math.cos(heading), math.sin(heading)
        turned = corners @ np.array([[cosine, -sine], [sine, cosine]])
        low, high = turned.min(axis=0), turned.max(axis=0)
        area = float(np.prod(high - low))
        if area < best[0] - 1e-9:
            middle = (low + high) / 2.0 @ np.array([[cosine, sine], [-sine, cosine]])
            best = (area, heading, middle, high - low)
    _, heading, middle, size = best
    return float(middle[0]), float(middle[1]), float(size[0]), float(size[1]), heading


def _outermost(corners: Floats) -> Floats:
    """Those of the convex hull, in order; all, where they lie in one line."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        return np.asarray(corners[np.sort(ConvexHull(corners).vertices)])
    except QhullError:
        return corners
