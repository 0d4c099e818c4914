"""How the competition interpolates road points: a cubic spline through them, at every meter.

The spline is that of FITPACK's `splprep` without smoothing: its parameter is the length of the
chords, and there is no knot at the second and the last but one point ("not a knot"; C. de Boor, A
Practical Guide to Splines, ch. IV).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

LEAST_NODES = 20
DECIMALS = 3


def interpolated(points: Floats) -> tuple[Floats, NDArray[np.int64]]:
    """Nodes (V, N, 2) of roads (V, n, 2), n >= 4, and how many each has (V,); those after the last
    are like the last."""
    chords = np.hypot(*np.moveaxis(np.diff(points, axis=1), -1, 0))
    length = chords.sum(axis=1)
    knots = np.concatenate([np.zeros((len(points), 1)), np.cumsum(chords, axis=1)], axis=1)
    knots = knots / knots[:, -1:]
    step = 1.0 / np.maximum(length.astype(np.int64), LEAST_NODES)
    counts = np.ceil((1.0 + step) / step).astype(np.int64)  # as `numpy.arange` counts
    number = np.minimum(np.arange(counts.max()), counts[:, None] - 1)
    nodes = _values(points, knots, number * step[:, None])
    return np.round(nodes, DECIMALS), counts


def _values(points: Floats, knots: Floats, u: Floats) -> Floats:
    """(V, N, 2) splines at parameters (V, N)."""
    h = np.diff(knots, axis=1)
    slope = np.diff(points, axis=1) / h[..., None]
    bend = _second_derivatives(h, slope)
    cells = h.shape[1]
    cell = np.minimum((u * cells).astype(np.int64), cells - 1)
    while True:  # the points are nearly even: one or two steps
        after = np.minimum(cell + 1, cells - 1)
        up = (np.take_along_axis(knots, after, 1) <= u) & (cell < cells - 1)
        down = np.take_along_axis(knots, cell, 1) > u
        if not (up.any() or down.any()):
            break
        cell = cell + up - (down & (cell > 0))
        if not (up.any() or (down & (cell > 0)).any()):
            break
    width = np.take_along_axis(h, cell, 1)[..., None]
    rest = (u - np.take_along_axis(knots, cell, 1))[..., None]
    at = cell[..., None]
    start, first, last = (
        np.take_along_axis(points, at, 1), np.take_along_axis(bend, at, 1),
        np.take_along_axis(bend, at + 1, 1),
    )  # fmt: skip
    rise = np.take_along_axis(slope, at, 1) - width * (2.0 * first + last) / 6.0
    return np.asarray(
        start + rest * (rise + rest * (0.5 * first + rest * (last - first) / (6.0 * width)))
    )


def _second_derivatives(h: Floats, slope: Floats) -> Floats:
    """(V, n, 2) second derivatives at the points: a tridiagonal system for the inner ones."""
    inner = h.shape[1] - 1
    below, above = h[:, :-1].copy(), h[:, 1:].copy()
    middle = 2.0 * (below + above)
    right = 6.0 * np.diff(slope, axis=1)
    start, end = h[:, 0] / h[:, 1], h[:, -1] / h[:, -2]
    middle[:, 0] += h[:, 0] * (1.0 + start)
    above[:, 0] -= h[:, 0] * start
    middle[:, -1] += h[:, -1] * (1.0 + end)
    below[:, -1] -= h[:, -1] * end
    for i in range(1, inner):
        share = below[:, i] / middle[:, i - 1]
        middle[:, i] -= share * above[:, i - 1]
        right[:, i] -= share[:, None] * right[:, i - 1]
    out = np.empty((len(h), inner + 2, 2))
    out[:, inner] = right[:, -1] / middle[:, -1:]
    for i in range(inner - 2, -1, -1):
        out[:, i + 1] = (right[:, i] - above[:, i : i + 1] * out[:, i + 2]) / middle[:, i : i + 1]
    out[:, 0] = (1.0 + start[:, None]) * out[:, 1] - start[:, None] * out[:, 2]
    out[:, -1] = (1.0 + end[:, None]) * out[:, -2] - end[:, None] * out[:, -3]
    return out
