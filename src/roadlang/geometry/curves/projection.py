"""The nearest point of a curve."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Floats, Integers, cross, finite
from ..errors import GeometryError
from .arclength import ArcLength
from .spline import frame_of

_CANDIDATES = 4
_STEPS = 12


def project(arc: ArcLength, closed: bool, points: ArrayLike) -> tuple[Floats, Floats]:
    """See `Curve.project`. Candidates from a k-d tree of the curve, refined by Newton's method."""
    spline = arc.spline
    targets = finite(points, "the points to project")
    if targets.ndim == 0 or targets.shape[-1] != 2:
        raise GeometryError("points to project must be pairs (x, y)")
    flat = targets.reshape(-1, 2)
    if len(flat) == 0:
        return np.empty(targets.shape[:-1]), np.empty(targets.shape[:-1])
    nearest = _nearest_samples(arc, flat)
    u = _refined(arc, flat[:, None, :], nearest)
    distance = np.linalg.norm(spline.position(u) - flat[:, None, :], axis=-1)
    best = np.take_along_axis(u, distance.argmin(axis=1)[:, None], axis=1)[:, 0]
    tangent, _ = frame_of(spline.derivatives(best)[0])
    offset = cross(tangent, flat - spline.position(best))
    s = arc.length_at(best)
    if closed:
        s = np.where(s >= arc.total, 0.0, s)
    return s.reshape(targets.shape[:-1]), offset.reshape(targets.shape[:-1])


def _nearest_samples(arc: ArcLength, flat: Floats) -> Integers:
    """(n, candidates) indices into the arc table."""
    from scipy.spatial import cKDTree

    samples = arc.spline.position(arc.parameters)
    count = min(_CANDIDATES, len(samples))
    _, nearest = cKDTree(samples).query(flat, k=count)
    return np.asarray(nearest, dtype=np.int64).reshape(len(flat), count)


def _refined(arc: ArcLength, flat: Floats, nearest: Integers) -> Floats:
    """Parameters of the local minima of distance beside each candidate, and the candidates."""
    spline, table = arc.spline, arc.parameters
    low, high = table[np.maximum(nearest - 1, 0)], table[np.minimum(nearest + 1, len(table) - 1)]
    start = table[nearest]
    u = start
    for _ in range(_STEPS):
        first, second, _ = spline.derivatives(u)
        away = spline.position(u) - flat
        slope = (away * first).sum(axis=-1)
        speed = np.maximum((first**2).sum(axis=-1), np.finfo(float).tiny)
        bend = speed + (away * second).sum(axis=-1)
        # Where the distance is not convex, Newton's step would go to a maximum.
        following = np.clip(u - slope / np.where(bend > 0.05 * speed, bend, speed), low, high)
        moved = np.abs(following - u).max()
        u = following
        if moved <= 1e-13 * float(table[-1]):
            break
    return np.concatenate([u, start], axis=1)
