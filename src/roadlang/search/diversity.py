"""How different accepted draws are from each other."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

_MOST = 2_000


def mean_nearest(points: Sequence[Any]) -> float | None:
    """Mean distance of each point to the nearest other, in the unit cube; None below two points.

    Points are sequences of numbers, or numbers by name; of more than 2,000 the first count.
    """
    if len(points) < 2:
        return None
    rows = points[:_MOST]
    if isinstance(rows[0], Mapping):
        names = sorted(set.intersection(*(set(row) for row in rows)))
        rows = [[row[name] for name in names] for row in rows]
    cube = np.asarray(rows, dtype=float)
    if cube.shape[1] == 0:
        return None
    square = (cube * cube).sum(axis=1)
    gaps = square[:, None] + square[None, :] - 2.0 * cube @ cube.T
    np.fill_diagonal(gaps, np.inf)
    return float(np.sqrt(np.maximum(gaps.min(axis=1), 0.0)).mean())
