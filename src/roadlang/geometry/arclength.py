"""Arc length of a planar piecewise cubic, and its inverse."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .arrays import Floats, SharedArrays
from .errors import GeometryError
from .spline import PiecewiseCubic

# Gauss-Legendre, eight points: exact for polynomials of degree 15.
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)
_FINEST = 64
_TOLERANCE = 1e-11


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
        lengths = path_lengths(spline, coarse[:-1], coarse[1:])
        while cuts < _FINEST:
            fine = subdivided(spline.knots, 2 * cuts)
            halves = path_lengths(spline, fine[:-1], fine[1:])
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
    inner = knots[:-1, None] + np.diff(knots)[:, None] * shares
    return np.concatenate([inner.ravel(), knots[-1:]])


def path_lengths(spline: PiecewiseCubic, start: Floats, stop: Floats) -> Floats:
    """Length of the path from each parameter `start` to `stop`, by Gauss-Legendre quadrature.

    `start` and `stop` must lie in one piece: the speed has kinks at the knots.
    """
    half = (stop - start) / 2.0
    middle = (stop + start) / 2.0
    u = middle[..., None] + half[..., None] * _NODES
    piece, _ = spline.locate(np.minimum(start, middle))
    t = u - spline.knots[piece][..., None]
    c = spline.coefficients[piece][..., None, :, :]
    dx, dy = (c[..., 1, k] + t * (2.0 * c[..., 2, k] + 3.0 * t * c[..., 3, k]) for k in (0, 1))
    return np.asarray(half * (np.hypot(dx, dy) @ _WEIGHTS))
