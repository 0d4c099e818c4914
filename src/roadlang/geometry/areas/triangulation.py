"""Triangles of a polygon, by clipping ears (Meisters, "Polygons have ears", 1975)."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Floats, Integers, cross, finite_points

_FLAT = 1e-12


def triangulated(ring: ArrayLike) -> Integers:
    """(t, 3) indices of the points of a simple ring (n, 2) that runs counter-clockwise.

    The triangles run counter-clockwise too. Points on a straight line between their neighbors are
    left out. Raises GeometryError for points that are not finite pairs.
    """
    points = finite_points(ring, "the points of a ring")
    left = list(range(len(points)))
    triangles: list[tuple[int, int, int]] = []
    at = tried = 0
    while len(left) > 2 and tried <= len(left):
        a, b, c = (left[(at + step) % len(left)] for step in (-1, 0, 1))
        area = float(cross(points[b] - points[a], points[c] - points[b]))
        is_ear = area > _FLAT and not _any_inside(points, left, (a, b, c))
        if is_ear:
            triangles.append((a, b, c))
        if is_ear or abs(area) <= _FLAT:
            left.pop(at % len(left))
            tried = 0
            at = at % max(len(left), 1)
        else:
            at, tried = (at + 1) % len(left), tried + 1
    return np.array(triangles, dtype=np.int64).reshape(-1, 3)


def _any_inside(points: Floats, left: list[int], corners: tuple[int, int, int]) -> bool:
    others = [i for i in left if i not in corners]
    candidates = points[others]
    inside = np.ones(len(others), dtype=bool)
    for start, stop in zip(corners, (*corners[1:], corners[0]), strict=True):
        side = cross(points[stop] - points[start], candidates - points[start])
        inside &= side >= -_FLAT
    same = (candidates[:, None] == points[list(corners)][None]).all(axis=-1).any(axis=1)
    return bool((inside & ~same).any())
