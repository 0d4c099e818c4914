"""A cheap guess of robustness from the candidates measured so far: Gaussian process regression."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..geometry.arrays import Floats

NOISE = 1e-3
MOST = 300
"""Points that a fit looks at: its work grows with their cube."""
_SCALES = (0.25, 0.5, 1.0, 2.0)


@dataclass(frozen=True)
class Surrogate:
    """Matern-5/2 kernel, a length for each coordinate (Rasmussen and Williams 2006, chapter 4)."""

    points: Floats
    lengths: Floats
    mean: Floats
    deviation: Floats
    weights: Floats
    factor: tuple[Floats, bool]

    @classmethod
    def fit(cls, points: Floats, values: Floats, lengths: Floats | None = None) -> Surrogate:
        """From points (n, d) in the unit cube and values (n, R).

        Lengths are chosen one coordinate after the other by the leave-one-out error (chapter 5);
        `lengths` of an earlier fit are a good start.
        """
        points, values = points[-MOST:], values[-MOST:]
        mean, deviation = values.mean(axis=0), values.std(axis=0) + 1e-9
        targets = (values - mean) / deviation
        dimensions = points.shape[1]
        if lengths is None:
            starts = [np.full(dimensions, s * np.sqrt(dimensions)) for s in _SCALES]
            lengths = min(starts, key=lambda start: _left_out(points, targets, start))
        best = _left_out(points, targets, lengths)
        for column in range(dimensions):
            for factor in (0.5, 2.0):
                tried = lengths.copy()
                tried[column] *= factor
                error = _left_out(points, targets, tried)
                if error < best:
                    best, lengths = error, tried
        from scipy.linalg import cho_factor, cho_solve

        factor_ = cho_factor(_covariance(points, lengths), lower=True)
        weights = cho_solve(factor_, targets)
        return cls(points, lengths, mean, deviation, weights, factor_)

    def chance(self, points: Floats) -> Floats:
        """(m,) the guessed probability that all values are positive."""
        from scipy.linalg import cho_solve
        from scipy.special import ndtr

        cross = _kernel(points, self.points, self.lengths)
        guess = cross @ self.weights * self.deviation + self.mean
        reduction = (cross.T * cho_solve(self.factor, cross.T)).sum(axis=0)
        spread = np.sqrt(np.maximum(1.0 + NOISE - reduction, 1e-9))[:, None] * self.deviation
        return np.asarray(ndtr(guess / spread).prod(axis=1))


def _kernel(a: Floats, b: Floats, lengths: Floats) -> Floats:
    a, b = a / lengths, b / lengths
    square = (a * a).sum(axis=1)[:, None] + (b * b).sum(axis=1)[None] - 2.0 * a @ b.T
    r = np.sqrt(5.0 * np.maximum(square, 0.0))
    return np.asarray((1.0 + r + r * r / 3.0) * np.exp(-r))


def _covariance(points: Floats, lengths: Floats) -> Floats:
    return _kernel(points, points, lengths) + NOISE * np.eye(len(points))


def _left_out(points: Floats, targets: Floats, lengths: Floats) -> float:
    """Mean squared error where each point is guessed from all others."""
    inverse = np.linalg.inv(_covariance(points, lengths))
    residual = (inverse @ targets) / np.diag(inverse)[:, None]
    return float((residual**2).mean())
