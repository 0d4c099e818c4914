"""A model of what was evaluated: what value and which descriptor a candidate should have."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_MOST = 800
"""Candidates that values are predicted from: those with the least values."""
_LENGTH = 0.1
"""Length scale of the kernel, in parts of the diagonal of the cube."""
_NOISE = 0.05
_RIDGE = 1e-2
_UNKNOWN = 1.0
"""The value far from everything: neither valid nor far from it."""


class FailureModel:
    """Values by the mean of a Gaussian process with a squared exponential kernel (Rasmussen and
    Williams 2006, algorithm 2.1), descriptors by linear regression."""

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
        best = np.argsort(values, kind="stable")[:_MOST]
        return self._value(vectors, known[best], values[best]), _linear(
            known[driven], described, vectors
        )

    def _value(self, vectors: Floats, known: Floats, values: Floats) -> Floats:
        import numpy as np

        scale = _LENGTH * np.sqrt(vectors.shape[1])
        kernel = _kernel(known, known, scale) + _NOISE * np.eye(len(known))
        weights = np.linalg.solve(kernel, np.minimum(values, 2.0) - _UNKNOWN)
        return np.asarray(_UNKNOWN + _kernel(vectors, known, scale) @ weights)


def _kernel(a: Floats, b: Floats, scale: float) -> Floats:
    import numpy as np

    return np.asarray(np.exp(squares_apart(a, b) * (-0.5 / scale**2)))


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
