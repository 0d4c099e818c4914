"""A model of what was evaluated: what value and which descriptor a candidate should have."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_MOST = 600
"""Candidates that values are predicted from: those with the least values."""
_LENGTH = 0.5
"""Length scale of the kernel, in root mean square distances of two random points."""
_LEAST_DISTANCE = 1e-9
_NOISE = 0.05
_DEVIATIONS = 6.0
"""Of the ranks of safe candidates, in the values from 0 to 1."""
_RIDGE = 1e-2
_UNKNOWN = 1.0
"""The value far from everything: neither valid nor far from it."""


class FailureModel:
    """Values by the mean of a Gaussian process with a Matern kernel of order 3/2 (Rasmussen
    and Williams 2006, algorithm 2.1 and equation 4.17), descriptors by linear regression. The
    process compares candidates and the descriptors that they should have: alike are those that
    make like roads."""

    def __init__(self) -> None:
        self._vectors: list[Floats] = []
        self._values: list[Floats] = []
        self._descriptors: list[Floats] = []

    def tell(self, vectors: Floats, values: Floats, descriptors: Floats) -> None:
        """What came of candidates. Without a descriptor (NaN) are those that were not driven."""
        self._vectors.append(vectors)
        self._values.append(values)
        self._descriptors.append(descriptors)

    def predicted(self, vectors: Floats) -> tuple[Floats, Floats]:
        """(n,) values and (n, D) descriptors of candidates (n, columns)."""
        import numpy as np

        known, values = np.concatenate(self._vectors), graded(np.concatenate(self._values))
        best = np.argsort(values, kind="stable")[:_MOST]
        weights = self._regression()
        found, of_known = (_compared(some, weights) for some in (vectors, known[best]))
        return _mean(found, of_known, values[best]), _applied(weights, vectors)

    def described(self, vectors: Floats) -> Floats:
        """(n, D) descriptors of candidates (n, columns)."""
        return _applied(self._regression(), vectors)

    def _regression(self) -> Floats:
        """(1 + columns, D) weights of a constant and of each number of a vector."""
        import numpy as np

        known = np.concatenate(self._vectors)
        found = np.concatenate([part for part in self._descriptors if part.shape[1]])
        driven = np.concatenate(
            [
                np.isfinite(part).all(axis=1) if part.shape[1] else np.zeros(len(part), bool)
                for part in self._descriptors
            ]
        )
        base = _with_constant(known[driven])
        square = base.T @ base + _RIDGE * np.eye(base.shape[1])
        described = found[np.isfinite(found).all(axis=1)]
        return np.asarray(np.linalg.solve(square, base.T @ described))


def _compared(vectors: Floats, weights: Floats) -> Floats:
    """Vectors and their descriptors side by side, each in root mean square distances of two random
    points of the cube."""
    import numpy as np

    slopes = weights[1:]
    usual = np.sqrt(vectors.shape[1] / 6.0)
    usual_of_descriptors = np.sqrt((slopes * slopes).sum() / 6.0)
    if usual_of_descriptors < _LEAST_DISTANCE:
        return np.asarray(vectors / usual)
    parts = (vectors / usual, _applied(weights, vectors) / usual_of_descriptors)
    return np.asarray(np.concatenate(parts, axis=1) / np.sqrt(2.0))


def _mean(found: Floats, known: Floats, values: Floats) -> Floats:
    """(n,) of the process, at `found` (n, d) where `known` (m, d) have these values."""
    import numpy as np
    from scipy.linalg import cho_factor, cho_solve

    kernel = _kernel(known, known) + _NOISE * np.eye(len(known))
    weights = cho_solve(cho_factor(kernel, overwrite_a=True), values - _UNKNOWN)
    return np.asarray(_UNKNOWN + _kernel(found, known) @ weights)


def graded(values: Floats) -> Floats:
    """(n,) values between 0 and 1 as normal scores of their ranks: robustness may hardly differ
    among safe drives and still say which of them came nearest to failing. From 2 on all is alike.
    """
    import numpy as np
    from scipy.special import ndtri

    found = np.minimum(values, 2.0)
    safe = np.flatnonzero((values >= 0.0) & (values < 1.0))
    order = np.argsort(values[safe], kind="stable")
    scores = ndtri((np.arange(len(safe)) + 0.5) / max(len(safe), 1))
    found[safe[order]] = np.clip(0.5 + scores / _DEVIATIONS, 0.0, 1.0)
    return np.asarray(found)


def _kernel(a: Floats, b: Floats) -> Floats:
    import numpy as np

    apart = np.sqrt(squares_apart(a, b) * (3.0 / _LENGTH**2))
    return np.asarray((1.0 + apart) * np.exp(-apart))


def squares_apart(a: Floats, b: Floats) -> Floats:
    """(n, m) squared distances of rows (n, D) and (m, D), to rounding."""
    import numpy as np

    square = (a * a).sum(axis=1)[:, None] + (b * b).sum(axis=1) - 2.0 * (a @ b.T)
    return np.asarray(np.maximum(square, 0.0))


def _with_constant(vectors: Floats) -> Floats:
    import numpy as np

    return np.column_stack([np.ones(len(vectors)), vectors])


def _applied(weights: Floats, vectors: Floats) -> Floats:
    import numpy as np

    return np.asarray(_with_constant(vectors) @ weights)
