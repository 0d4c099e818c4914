"""How different accepted draws are from each other."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..geometry.arrays import Floats

_MOST = 2_000
_TOGETHER = 64
"""Points whose distances to all are in memory at a time."""


def mean_nearest(points: Sequence[Any]) -> float | None:
    """Mean distance of each point to the nearest other, in the unit cube; None below two points.

    Points are sequences of numbers, or numbers by name; of more than 2,000 the first count.
    """
    cube = _in_cube(points)
    return None if cube is None else _mean_nearest(cube)


def expected_nearest(points: Sequence[Any], share: float) -> float | None:
    """What `mean_nearest` comes to for as many even draws in a cube that is `share` of the unit
    cube: an estimate for even draws in any part of it that is as large, and not very thin."""
    cube = _in_cube(points)
    if cube is None:
        return None
    count, dimensions = cube.shape
    even = np.random.Generator(np.random.Philox(key=count)).random((count, dimensions))
    return float(share ** (1.0 / dimensions)) * _mean_nearest(even)


def _in_cube(points: Sequence[Any]) -> Floats | None:
    if len(points) < 2:
        return None
    rows = points[:_MOST]
    if isinstance(rows[0], Mapping):
        names = sorted(set.intersection(*(set(row) for row in rows)))
        rows = [[row[name] for name in names] for row in rows]
    cube = np.asarray(rows, dtype=float)
    return None if cube.shape[1] == 0 else cube


def _mean_nearest(cube: Floats) -> float:
    square = (cube * cube).sum(axis=1)
    nearest = np.empty(len(cube))
    for start in range(0, len(cube), _TOGETHER):
        rows = np.arange(start, min(start + _TOGETHER, len(cube)))
        gaps = square[rows, None] + square - 2.0 * cube[rows] @ cube.T
        gaps[rows - start, rows] = np.inf
        nearest[rows] = gaps.min(axis=1)
    return float(np.sqrt(np.maximum(nearest, 0.0)).mean())
