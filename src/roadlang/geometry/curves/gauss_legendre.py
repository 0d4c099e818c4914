"""Lengths of paths along planar piecewise cubics, by Gauss-Legendre quadrature."""

from __future__ import annotations

import numpy as np

from ..arrays import Floats, Integers
from .spline import PiecewiseCubic

# Gauss-Legendre, eight points: exact for polynomials of degree 15.
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)
_TOGETHER = 1024
"""Stretches whose nodes fit the first caches together."""


def subdivided(starts: Floats, stops: Floats, cuts: int) -> Floats:
    """Where (m, cuts) `cuts` equal steps from each start to its stop (m,) begin."""
    return np.asarray(starts[:, None] + (stops - starts)[:, None] * (np.arange(cuts) / cuts))


def path_lengths(
    spline: PiecewiseCubic, start: Floats, stop: Floats, piece: Integers | None = None
) -> Floats:
    """Length of the path from each parameter `start` to `stop`, by Gauss-Legendre quadrature.

    `start` and `stop` must lie in one piece, `piece` where it is known: the speed has kinks at the
    knots.
    """
    half = (stop - start) / 2.0
    middle = (stop + start) / 2.0
    if piece is None:
        piece, _ = spline.locate(np.minimum(start, middle))
    halves, middles, pieces = half.reshape(-1), middle.reshape(-1), piece.reshape(-1)
    speeds = np.empty((half.size, len(_NODES)))
    for begin in range(0, half.size, _TOGETHER):
        part = slice(begin, begin + _TOGETHER)
        _speeds(spline, halves[part], middles[part], pieces[part], into=speeds[part])
    return np.asarray(half * (speeds.reshape(*half.shape, len(_NODES)) @ _WEIGHTS))


def _speeds(
    spline: PiecewiseCubic, half: Floats, middle: Floats, piece: Integers, into: Floats
) -> None:
    """The speed at the nodes (n, 8) around the middles (n,) of stretches."""
    # Node by node: rows of n numbers are worked through several times as fast as rows of eight.
    t = middle + half * _NODES[:, None] - spline.knots[piece]
    thrice, c = 3.0 * t, spline.coefficients[piece]
    dx, dy = (_derivative(c[:, :, k], t, thrice) for k in (0, 1))
    into[:] = np.hypot(dx, dy).T


def _derivative(coefficients: Floats, t: Floats, thrice: Floats) -> Floats:
    first, second, third = np.ascontiguousarray(coefficients[:, 1:].T)
    return np.asarray(first + t * (2.0 * second + thrice * third))
