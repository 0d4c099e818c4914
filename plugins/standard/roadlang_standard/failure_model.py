"""A model of what was evaluated: what value and which descriptor a candidate should have."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_MOST = 600
"""Candidates that values are predicted from: those with the least values."""
_LENGTH = 0.2
"""Length scale of the kernel, in parts of the diagonal of the cube."""
_NOISE = 0.05
_DEVIATIONS = 6.0
"""Of the ranks of safe candidates, in the values from 0 to 1."""
_RIDGE = 1e-2
_UNKNOWN = 1.0
"""The value far from everything: neither valid nor far from it."""


class FailureModel:
    """Values by the mean of a Gaussian process with a Matern kernel of order 3/2 (Rasmussen
    and Williams 2006, algorithm 2.1 and equation 4.17), descriptors by linear regression."""

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

        known, values = np.concatenate(self._vectors), np.concatenate(self._values)
        found = np.concatenate([part for part in self._descriptors if part.shape[1]])
        driven = np.concatenate(
            [
                np.isfinite(part).all(axis=1) if part.shape[1] else np.zeros(len(part), bool)
                for part in self._descriptors
            ]
        )
        described = found[np.isfinite(found).all(axis=1)]
        values = graded(values)
        best = np.argsort(values, kind="stable")[:_MOST]
        return self._value(vectors, known[best], values[best]), _linear(
            known[driven], described, vectors
        )

    def _value(self, vectors: Floats, known: Floats, values: Floats) -> Floats:
        import numpy as np
        from scipy.linalg import cho_factor, cho_solve

        scale = _LENGTH * np.sqrt(vectors.shape[1])
        kernel = _kernel(known, known, scale) + _NOISE * np.eye(len(known))
        weights = cho_solve(cho_factor(kernel, overwrite_a=True), values - _UNKNOWN)
        return np.asarray(_UNKNOWN + _kernel(vectors, known, scale) @ weights)


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


def _kernel(a: Floats, b: Floats, scale: float) -> Floats:
    import numpy as np

    apart = np.sqrt(squares_apart(a, b) * (3.0 / scale**2))
    return np.asarray((1.0 + apart) * np.exp(-apart))


def squares_apart(a: Floats, b: Floats) -> Floats:
    """(n, m) squared distances of rows (n, D) and (m, D), to rounding."""
    import numpy as np

    square = (a * a).sum(axis=1)[:, None] + (b * b).sum(axis=1) - 2.0 * (a @ b.T)
    return np.asarray(np.maximum(square, 0.0))


def _linear(known: Floats, found: Floats, vectors: Floats) -> Floats:
    import numpy as np

    base = np.column_stack([np.ones(len(known)), known])
    square = base.T @ base + _RIDGE * np.eye(base.shape[1])
    weights = np.linalg.solve(square, base.T @ found)
    return np.asarray(np.column_stack([np.ones(len(vectors)), vectors]) @ weights)
