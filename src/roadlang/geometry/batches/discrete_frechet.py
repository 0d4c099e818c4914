"""The discrete Frechet distance of many pairs of curves at once."""

from __future__ import annotations

import numpy as np

from ..arrays import Floats
from ..errors import GeometryError
from .batch import CurveBatch


def frechet(a: CurveBatch, b: CurveBatch) -> Floats:
    """(V,) discrete Frechet distance of the sampled points, meters; V may be 1 in one of them.

    Exceeds the continuous one by at most the longest step of the samples. Eiter and Mannila
    (1994), one anti-diagonal of the table at a time: S + T steps over V rows, V S T operations and
    3 V S numbers of memory.
    """
    count = max(a.variants, b.variants)
    if not {a.variants, b.variants} <= {1, count}:
        raise GeometryError(f"{a.variants} variants cannot be compared with {b.variants}")
    p = np.ascontiguousarray(np.moveaxis(a.points, -1, 0))
    q = np.ascontiguousarray(np.moveaxis(b.points, -1, 0))[..., ::-1]
    rows, columns = p.shape[-1], q.shape[-1]
    # Cell (i, k - i) of diagonal k is kept at i + 1; the borders are infinitely far.
    before = np.full((count, rows + 1), np.inf)
    latest = np.full((count, rows + 1), np.inf)
    before[:, 0] = 0.0
    for k in range(rows + columns - 1):
        low, high = max(0, k - columns + 1), min(k, rows - 1) + 1
        near = p[..., low:high] - q[..., columns - 1 - k + low : columns - 1 - k + high]
        gap = near[0] ** 2 + near[1] ** 2
        previous = np.minimum(latest[:, low:high], latest[:, low + 1 : high + 1])
        np.minimum(previous, before[:, low:high], out=previous)
        following = np.full((count, rows + 1), np.inf)
        np.maximum(gap, previous, out=following[:, low + 1 : high + 1])
        before, latest = latest, following
    return np.sqrt(latest[:, rows])
