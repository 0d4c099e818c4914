"""How a displacement along the normal changes a curve, row by row in blocks that fit the cache."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .arrays import Floats

_BLOCK = 1 << 14
_SMALLEST = 1e-12


def turned_curvature(
    displacement: Floats, slope: Floats, bend: Floats, curvature: Floats, curvature_slope: Floats
) -> Floats:
    """Curvature (V, S) of `r + e n` from e, e', e'' (V, S) and k, k' (S,) of the base r.

    With a = 1 - k e and v^2 = a^2 + e'^2:
    (a (a k + e'') + e' (k' e + 2 k e')) / v^3.
    """
    result = np.empty(displacement.shape)
    for rows in blocks(displacement):
        e, de, dde = displacement[rows], slope[rows], bend[rows]
        out = result[rows]
        forward = 1.0 - curvature * e
        square = de * de
        np.multiply(curvature, forward, out=out)
        out += dde
        out *= forward
        sideways = curvature_slope * e
        sideways += (2.0 * curvature) * de
        sideways *= de
        out += sideways
        forward *= forward
        square += forward
        np.maximum(square, _SMALLEST, out=square)
        np.sqrt(square, out=forward)
        square *= forward
        out /= square
    return result


def blocks(rows: Floats) -> Iterator[slice]:
    """Slices of rows of about 128 KiB."""
    step = max(1, _BLOCK // max(rows.shape[1], 1))
    for start in range(0, len(rows), step):
        yield slice(start, start + step)
