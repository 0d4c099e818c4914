"""The curvature of a line displaced in many ways, row by row in blocks that fit the cache."""

from __future__ import annotations

import numpy as np

from ..arrays import Floats
from ..numbers.differences import Differences
from ..numbers.row_blocks import blocks

SLOWEST = 1e-6
"""Meters of a line for a meter along the stations: what runs more slowly counts as this slow."""


def displaced_curvature(
    displacement: Floats, differences: Differences, curvature: Floats, curvature_slope: Floats
) -> Floats:
    """Curvature (V, S) of `r + e n` from e (V, S), and k, k' (S,) of the base r, v = 1.

    With f = 1 - k e and w^2 = f^2 + e'^2: (f (f k + e'') + e' (k' e + 2 k e')) / w^3.
    """
    result = np.empty(displacement.shape)
    doubled = 2.0 * curvature
    buffers = np.empty((4, 0, 0))
    for rows in blocks(displacement, 1 << 14):
        e, out = displacement[rows], result[rows]
        if len(e) > buffers.shape[1]:
            buffers = np.empty((4, *e.shape))
        slope, bend, forward, square = buffers[:, : len(e)]
        differences.derivative(e, 1, slope)
        differences.derivative(e, 2, bend)
        np.multiply(curvature, e, out=forward)
        np.subtract(1.0, forward, out=forward)
        np.multiply(curvature, forward, out=out)
        out += bend
        out *= forward
        sideways = np.multiply(curvature_slope, e, out=bend)
        sideways += np.multiply(doubled, slope, out=square)
        sideways *= slope
        out += sideways
        np.multiply(slope, slope, out=square)
        forward *= forward
        square += forward
        np.maximum(square, SLOWEST**2, out=square)
        np.sqrt(square, out=forward)
        square *= forward
        out /= square
    return result
