"""Arc length of a planar piecewise cubic, and its inverse."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .arrays import Floats, Integers, SharedArrays
from .errors import GeometryError
from .spline import PiecewiseCubic

# Gauss-Legendre, eight points: exact for polynomials of degree 15.
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)
_FINEST = 64
_TOLERANCE = 1e-11
_TOGETHER = 1024
"""Stretches whose nodes fit the first caches together."""


@dataclass(frozen=True, eq=False)
class ArcLength(SharedArrays):
    """A table of parameters (k,) and the arc length (k,) at each, fine enough to invert."""

    spline: PiecewiseCubic
    parameters: Floats
    lengths: Floats

    @classmethod
    def of(cls, spline: PiecewiseCubic) -> ArcLength:
        """Refines the table until halving its steps changes no length."""
        cuts = 4
        coarse = subdivided(spline.knots, cuts)
        lengths = lengths_of_cuts(spline, coarse, cuts)
        while cuts < _FINEST:
            fine = subdivided(spline.knots, 2 * cuts)
            halves = lengths_of_cuts(spline, fine, 2 * cuts)
            together = halves.reshape(-1, 2).sum(axis=1)
            change = np.abs(together - lengths).max()
            cuts, coarse, lengths = 2 * cuts, fine, halves
            if change <= _TOLERANCE * together.sum():
                break
        total = np.concatenate([[0.0], np.cumsum(lengths)])
        if not np.isfinite(total[-1]) or total[-1] <= 0.0:
            raise GeometryError("the curve has no finite length")
        return cls(spline, coarse, total)

    @property
    def total(self) -> float:
        """Meters."""
        return float(self.lengths[-1])

    def parameter(self, s: Floats) -> Floats:
        """The parameter at each arc length in [0, total], by Newton's method in its table cell."""
        cell = np.searchsorted(self.lengths, s, side="right") - 1
        cell = np.clip(cell, 0, len(self.lengths) - 2)
        low, high = self.parameters[cell], self.parameters[cell + 1]
        rest = s - self.lengths[cell]
        span = np.maximum(self.lengths[cell + 1] - self.lengths[cell], np.finfo(float).tiny)
        u = low + (high - low) * np.clip(rest / span, 0.0, 1.0)
        for _ in range(12):
            missing = rest - path_lengths(self.spline, low, u)
            speed = np.maximum(self.spline.speed(u), 1e-12)
            following = np.clip(u + missing / speed, low, high)
            moved = np.abs(following - u).max(initial=0.0)
            u = following
            # Newton's method squares the error: what is left is far below rounding.
            if moved <= 1e-9 * float(self.parameters[-1]):
                break
        return np.asarray(u)

    def length_at(self, u: Floats) -> Floats:
        """The arc length at each parameter, within its table cell whatever the rounding."""
        cell = np.searchsorted(self.parameters, u, side="right") - 1
        cell = np.clip(cell, 0, len(self.parameters) - 2)
        low, high = self.lengths[cell], self.lengths[cell + 1]
        length = low + path_lengths(self.spline, self.parameters[cell], u)
        return np.asarray(np.clip(length, low, high))


def subdivided(knots: Floats, cuts: int) -> Floats:
    """Every step between knots cut into `cuts` equal ones."""
    shares = np.arange(cuts) / cuts
    inner = knots[:-1, None] + (knots[1:] - knots[:-1])[:, None] * shares
    return np.concatenate([inner.ravel(), knots[-1:]])


def lengths_of_cuts(spline: PiecewiseCubic, parameters: Floats, cuts: int) -> Floats:
    """The length of each step of `parameters`, which are the knots `subdivided` into `cuts`."""
    piece = np.repeat(np.arange(len(spline.coefficients)), cuts)
    return path_lengths(spline, parameters[:-1], parameters[1:], piece)


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
