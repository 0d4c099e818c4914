"""Fewer points that look the same, and numbers in few characters."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from ..geometry.arrays import Floats, Integers


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
