"""Fewer points that look the same, and numbers in few characters."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from ..geometry.arrays import Floats, Integers


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


def samples_of(count: int, most: int, series: Iterable[Floats], also: Iterable[int]) -> Integers:
    """About `most` of `count` samples, evenly spread, the last among them; of every interval those
    with the least and the greatest value of each series; and `also`."""
    if count <= most:
        return np.arange(count)
    chosen = {0, count - 1, *also}
    edges = np.linspace(0, count, most + 1).astype(int)
    chosen |= set(edges[:-1].tolist())
    for values in series:
        finite = np.where(np.isfinite(values), values, np.nan)
        if np.isnan(finite).all():
            continue
        chosen |= {int(np.nanargmin(finite)), int(np.nanargmax(finite))}
    return np.array(sorted(chosen))


def deltas(values: Floats | Sequence[float], scale: float) -> list[int]:
    """Whole numbers of steps of `1 / scale`: the first value, then differences from one to the
    next. Rounding does not add up. Values that are not finite repeat the one before."""
    steps = np.round(np.asarray(values, dtype=float) * scale)
    places = np.where(np.isfinite(steps), np.arange(len(steps)), -1)
    known = np.maximum.accumulate(places)
    first = int(np.argmax(np.isfinite(steps))) if np.isfinite(steps).any() else -1
    if first < 0:
        return []
    filled = steps[np.where(known < 0, first, known)]
    found: list[int] = np.diff(filled, prepend=0.0).astype(int).tolist()
    return found
