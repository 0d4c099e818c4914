"""Distances between batches of curves that share their stations. Rows are variants."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Floats, finite, norm
from ..errors import GeometryError
from .batch import CurveBatch
from .displacement import DisplacedBatch


def pointwise(a: CurveBatch, b: CurveBatch) -> Floats:
    """(V, S) meters between the points of `a` and `b` at the same station; V may be 1 in one."""
    shared = _shared_displacements(a, b)
    if shared is not None:
        return np.abs(np.subtract(*shared))
    _check_stations(a, b)
    return norm(a.points - b.points)


def lp_norm(values: Floats, weights: Floats, p: ArrayLike) -> Floats:
    """(V,) (sum of `weights` (S,) times |`values` (V, S)|^p)^(1/p); `p` >= 1, a number or (V, 1).

    Of pointwise distances and the weights of `quadrature` the paper's d_p, in m^(1 + 1/p).
    """
    largest = np.maximum(np.abs(values).max(axis=1, keepdims=True), np.finfo(float).tiny)
    # Row by row: a product of matrices rounds a row by how many there are beside it.
    integral = np.array([row @ weights for row in (np.abs(values) / largest) ** p])
    return np.asarray(largest[:, 0] * integral ** (1.0 / np.ravel(p)))


def margin(batch: CurveBatch, p: ArrayLike, q: ArrayLike) -> Floats:
    """(V, S) meters to the nearest edge of the box with corners `p` and `q`, negative outside."""
    first, second = finite(p, "the corners of a box"), finite(q, "the corners of a box")
    if first.shape != (2,) or second.shape != (2,):
        raise GeometryError("a box needs two corners (x, y)")
    low, high = np.minimum(first, second), np.maximum(first, second)
    result = np.full(batch.points.shape[:2], np.inf)
    for axis in (0, 1):
        places = batch.points[..., axis]
        np.minimum(result, places - low[axis], out=result)
        np.minimum(result, high[axis] - places, out=result)
    return result


def quadrature(batch: CurveBatch) -> Floats:
    """(S,) weights of the trapezoidal rule over the stations, meters."""
    gaps = np.diff(batch.stations)
    weights = np.zeros(len(batch.stations))
    weights[:-1] += gaps / 2.0
    weights[1:] += gaps / 2.0
    if batch.period is not None:
        seam = (batch.stations[0] + batch.period - batch.stations[-1]) / 2.0
        weights[[0, -1]] += seam
    return weights


def _shared_displacements(a: CurveBatch, b: CurveBatch) -> tuple[Floats, Floats] | None:
    if isinstance(a, DisplacedBatch) and isinstance(b, DisplacedBatch) and a.frame.same_as(b.frame):
        return a.displacement, b.displacement
    return None


def _check_stations(a: CurveBatch, b: CurveBatch) -> None:
    if len(a.stations) != len(b.stations):
        raise GeometryError("curves can be compared only at the same stations")
    if a.variants != b.variants and 1 not in (a.variants, b.variants):
        raise GeometryError(f"{a.variants} variants cannot be compared with {b.variants}")
