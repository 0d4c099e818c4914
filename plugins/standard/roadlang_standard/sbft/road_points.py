"""Points of roads in the map of the competition."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

LEAST = 4
"""points: with fewer the competition does not interpolate by cubic splines"""
DECIMALS = 3
"""of meters, in the points"""


def point_counts(length: Floats, spacing: float) -> NDArray[np.int64]:
    """(V,) how many points roads of these lengths get."""
    return np.maximum(LEAST, np.ceil(length / spacing - 1e-9).astype(np.int64) + 1)


def road_points(
    points: Floats, heading: Floats, spacing: float, size: float, centered: bool
) -> Iterator[tuple[NDArray[np.int64], Floats]]:
    """Roads (V, S, 2) as points at even distances, about `spacing` meters: those with the same
    number n of points together, as rows (R,) and their points (R, n, 2).

    `centered`: in the middle of the map of `size` meters; otherwise where they are. Between two
    stations a road is a cubic with the headings (V, S) of these.
    """
    chords = np.hypot(*np.moveaxis(np.diff(points, axis=1), -1, 0))
    along = np.concatenate([np.zeros((len(points), 1)), np.cumsum(chords, axis=1)], axis=1)
    counts = point_counts(along[:, -1], spacing)
    for count in np.unique(counts):
        rows = np.flatnonzero(counts == count)
        found = _between(points[rows], heading[rows], along[rows], int(count))
        if centered:
            middle = 0.5 * (found.max(axis=1) + found.min(axis=1))
            found = found - middle[:, None] + 0.5 * size
        yield rows, np.round(found, DECIMALS)


def _between(points: Floats, heading: Floats, along: Floats, count: int) -> Floats:
    """(R, count, 2) points at even distances along each road."""
    share = np.arange(count) / (count - 1)
    s = share * along[:, -1:]
    cell = np.array([np.searchsorted(a, b, side="right") for a, b in zip(along, s, strict=True)])
    cell = np.minimum(np.maximum(cell - 1, 0), along.shape[1] - 2)
    start, end = np.take_along_axis(along, cell, 1), np.take_along_axis(along, cell + 1, 1)
    chord = np.maximum(end - start, 1e-9)
    u = ((s - start) / chord)[..., None]
    first, last = (np.take_along_axis(points, (cell + i)[..., None], 1) for i in (0, 1))
    slopes = []
    for i in (0, 1):
        angle = np.take_along_axis(heading, cell + i, 1)
        slopes.append(np.stack((np.cos(angle), np.sin(angle)), axis=-1) * chord[..., None])
    # Hermite's cubic.
    v = 1.0 - u
    return np.asarray(
        v * v * ((1.0 + 2.0 * u) * first + u * slopes[0])
        + u * u * ((1.0 + 2.0 * v) * last - v * slopes[1])
    )
