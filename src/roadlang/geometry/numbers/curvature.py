"""The curvature of lines of points, many at once."""

from __future__ import annotations

import numpy as np

from ..arrays import Floats
from .row_blocks import blocks

_SMALLEST = np.finfo(float).tiny


def curvature_of_points(x: Floats, y: Floats, closed: bool) -> Floats:
    """(V, S) 1/m, left positive, of lines through points `x`, `y` (V, S), meters.

    At each point that of the circle through it and its two neighbors, the Menger curvature
    `2 sin(turn) / |p[i+1] - p[i-1]|`; at the ends of an open line that of its neighbor. Exact on
    circles; on a smooth curve the error is second order in the distance of the points. Zero where
    fewer than three points, or points that coincide, tell no circle.
    """
    if closed:
        x, y = (np.concatenate([c[:, -1:], c, c[:, :1]], axis=1) for c in (x, y))
    result = np.zeros((len(x), x.shape[1] - (2 if closed else 0)))
    inner = result if closed else result[:, 1:-1]
    if x.shape[1] < 3:
        return result
    for rows in blocks(x):
        inner[rows] = _between_neighbors(x[rows], y[rows])
    if not closed:
        result[:, 0], result[:, -1] = result[:, 1], result[:, -2]
    return result


def _between_neighbors(x: Floats, y: Floats) -> Floats:
    """(V, S - 2) 2 (a x b) / (|a| |b| |a + b|) for each step `a` and the step `b` after it."""
    dx, dy = x[:, 1:] - x[:, :-1], y[:, 1:] - y[:, :-1]
    square = dx * dx
    square += dy * dy
    ax, ay, bx, by = dx[:, :-1], dy[:, :-1], dx[:, 1:], dy[:, 1:]
    turned = ax * by
    turned -= ay * bx
    turned *= 2.0
    across = ax * bx
    across += ay * by
    across *= 2.0
    across += square[:, :-1]
    across += square[:, 1:]
    across *= square[:, :-1]
    across *= square[:, 1:]
    np.sqrt(across, out=across)
    # Where two of the three points are one, the numerator is zero as well.
    turned /= np.maximum(across, _SMALLEST, out=across)
    return turned
