"""Regression with a kernel that learns along which directions the values change."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Singles = NDArray[np.float32]

_NOISE = 0.05
"""Variance of the noise, in parts of that of the values."""
_RIDGE = 0.1
"""What the metric keeps of every direction, in parts of what it has in a usual one."""
_LEAST = 1e-12
_AT_ONCE = 512
"""Vectors whose values are predicted together: their distances fit into the caches."""


class Kernel:
    """Kernel ridge regression, which is the mean of a Gaussian process (Rasmussen and Williams
    2006, equation 2.25), with a Matern kernel of order 3/2 (equation 4.17) of distances.

    `mean`: the value far from everything."""

    def __init__(self, mean: float) -> None:
        self._mean = mean
        self.weights = _none()
        self._singles: tuple[Singles, Singles, Singles, Singles] | None = None
        """of the last fit what predictions take: points, their squares, weights, and the factor of
        the kernel"""
        self._variance = 0.0
        """of the values, as the process has it that the kernel stands for"""

    def fit(self, points: Floats, values: Floats) -> Floats:
        """Learn from points (m, D), of which two are usually 1 apart, with their values (m,). Gives
        (m, m), by how much one value matters less for another the further apart they are: the slope
        of the kernel over the squares of distances, but for a constant factor."""
        import numpy as np
        from scipy.linalg import cho_factor, cho_solve

        apart = np.sqrt(3.0 * squares_apart(points, points))
        decay = np.exp(-apart)
        kernel = (1.0 + apart) * decay
        kernel[np.diag_indices(len(kernel))] += _NOISE
        factor = cho_factor(kernel, lower=True, overwrite_a=True, check_finite=False)
        self.weights = cho_solve(factor, values - self._mean, check_finite=False)
        known, weights = points.astype(np.float32), self.weights.astype(np.float32)
        self._singles = known, squares(known), weights, factor[0].astype(np.float32)
        self._variance = float((values - self._mean) @ self.weights) / len(values)
        return np.asarray(decay)

    def predicted(self, points: Floats | Singles, optimism: float = 0.0) -> Floats:
        """(n,) values of points (n, D), by the last fit, less `optimism` times the standard
        deviation of what they may be (equation 2.26; the variance of the process is that of
        equation 5.4 at its maximum): a lower confidence bound (Cox and John 1992)."""
        import numpy as np

        # Single precision is enough to tell which are better.
        single = points.astype(np.float32, copy=False)
        parts = (single[first : first + _AT_ONCE] for first in range(0, len(single), _AT_ONCE))
        return np.concatenate([np.empty(0), *(self._of_part(part, optimism) for part in parts)])

    def _of_part(self, points: Singles, optimism: float) -> Floats:
        import numpy as np
        from scipy.linalg import solve_triangular

        assert self._singles is not None
        known, of_known, weights, factor = self._singles
        apart = squares_apart(points, known, of_known)
        apart *= 3.0
        np.sqrt(apart, out=apart)
        kernel = np.exp(-apart)
        apart += 1.0
        kernel *= apart
        found = self._mean + (kernel @ weights).astype(np.float64)
        if not optimism:
            return np.asarray(found)
        solved = solve_triangular(factor, kernel.T, lower=True, check_finite=False)
        unknown = np.maximum(1.0 - np.einsum("ij,ij->j", solved, solved), 0.0)
        return np.asarray(found - optimism * np.sqrt(max(self._variance, 0.0) * unknown))


class LearnedKernel:
    """Regression with a kernel of Mahalanobis distances. Their metric is the mean outer product of
    the gradients of the regression before (recursive feature machine: Radhakrishnan, Beaglehole,
    Pandit and Belkin 2024): a direction in which the values hardly change makes candidates hardly
    less alike. Each fit is one step of that recursion, so the metric follows what is known as it
    grows.

    `mean`: the value far from everything."""

    def __init__(self, mean: float) -> None:
        self._kernel = Kernel(mean)
        self._metric: Floats | None = None
        self._map = _none()

    def fit(self, vectors: Floats, values: Floats) -> None:
        """Learn from vectors (m, columns) with their values (m,)."""
        import numpy as np

        metric = np.eye(vectors.shape[1]) if self._metric is None else self._metric
        self._map = _scaled(_square_root(metric), vectors)
        decay = self._kernel.fit(self.mapped(vectors), values)
        decay *= self._kernel.weights
        # Of each known vector the gradient of the regression, but for a constant factor.
        gradients = (decay.sum(axis=1)[:, None] * vectors - decay @ vectors) @ metric
        self._metric = _metric_of(gradients, metric)

    def mapped(self, vectors: Floats) -> Floats:
        """Vectors (n, columns) as points of which two are usually 1 apart, by the last fit."""
        import numpy as np

        return np.asarray(vectors @ self._map)

    def predicted(self, vectors: Floats, optimism: float = 0.0) -> Floats:
        """(n,) values of vectors (n, columns), as `Kernel.predicted` has them."""
        return self._kernel.predicted(self.mapped(vectors), optimism)


def squares_apart(
    a: NDArray[Any], b: NDArray[Any], of_b: NDArray[Any] | None = None
) -> NDArray[Any]:
    """(n, m) squared distances of rows (n, D) and (m, D), to rounding; `of_b`: the `squares` of b,
    where they are known."""
    import numpy as np

    square = a @ b.T
    square *= -2.0
    square += squares(a)[:, None]
    square += squares(b) if of_b is None else of_b
    return np.asarray(np.maximum(square, 0.0, out=square))


def squares(rows: NDArray[Any]) -> NDArray[Any]:
    """(n,) squared lengths of rows (n, D)."""
    found: NDArray[Any] = (rows * rows).sum(axis=1)
    return found


def _scaled(root: Floats, vectors: Floats) -> Floats:
    """The map with which two of the vectors usually (root mean square) are 1 apart."""
    import numpy as np

    usual = np.sqrt(2.0 * (vectors @ root).var(axis=0).sum())
    return np.asarray(root / max(float(usual), _LEAST))


def _square_root(metric: Floats) -> Floats:
    """(D, D) R with R R' the metric."""
    import numpy as np

    values, vectors = np.linalg.eigh(metric)
    return np.asarray(vectors * np.sqrt(np.maximum(values, 0.0)))


def _metric_of(gradients: Floats, before: Floats) -> Floats:
    """The metric of the next fit: `before`, where nothing changes."""
    import numpy as np

    product = gradients.T @ gradients
    trace = float(np.trace(product))
    if trace < _LEAST:
        return before
    return np.asarray(product * (len(product) / trace) + _RIDGE * np.eye(len(product)))


def _none() -> Floats:
    import numpy as np

    return np.empty((0, 0))
