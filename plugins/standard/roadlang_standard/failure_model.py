"""A model of what was evaluated: what value and which descriptor a candidate should have."""

from __future__ import annotations

from typing import TYPE_CHECKING

from roadlang.api import ROAD_PLACES

from .bend_model import BendModel
from .learned_kernel import LearnedKernel

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_MOST = 600
"""Candidates that values are predicted from: those with the least values."""
_DEVIATIONS = 6.0
"""Of the ranks of safe candidates, in the values from 0 to 1."""
_RIDGE = 1e-2
_UNKNOWN = 1.0
"""The value far from everything: neither valid nor far from it."""


class FailureModel:
    """Values by a kernel that learns what matters for them, where roads differ by their bends too;
    descriptors by linear regression."""

    def __init__(self) -> None:
        self._kernel = LearnedKernel(_UNKNOWN)
        self._bends = BendModel()
        self._is_by_bends = False
        self._vectors: list[Floats] = []
        self._values: list[Floats] = []
        self._descriptors: list[Floats] = []

    def tell(self, vectors: Floats, values: Floats, descriptors: Floats) -> None:
        """What came of candidates. Without a descriptor (NaN) are those that were not driven."""
        self._vectors.append(vectors)
        self._values.append(values)
        self._descriptors.append(descriptors)

    def fit(self) -> None:
        """Learn from what was told since the last time, and before."""
        import numpy as np

        known, told = np.concatenate(self._vectors), np.concatenate(self._values)
        values = graded(told)
        best = np.argsort(values, kind="stable")[:_MOST]
        self._kernel.fit(known[best], values[best])
        driven = best[values[best] < 1.0]
        self._is_by_bends = bool(len(driven) and self._has_roads)
        if self._is_by_bends:
            self._fit_bends(known[driven], values[driven])

    @property
    def _has_roads(self) -> bool:
        return bool(max(part.shape[1] for part in self._descriptors) >= ROAD_PLACES)

    def _fit_bends(self, driven: Floats, values: Floats) -> None:
        import numpy as np

        weights = self._regression()[:, :ROAD_PLACES]
        road = np.delete(weights, 1, axis=0)  # what it is where nothing fails
        self._bends.fit(driven, self._kernel.mapped(driven), road, values)
        self._is_by_bends = self._bends.is_fit

    def predicted(self, vectors: Floats, optimism: float) -> tuple[Floats, Floats]:
        """(n,) values and (n, k) what `described` gives of candidates (n, columns), by the last
        fit; the values less `optimism` times their standard deviation."""
        described = self.described(vectors)
        if self._is_by_bends:
            others = self._kernel.mapped(vectors)
            return self._bends.predicted(vectors, others, optimism), described
        return self._kernel.predicted(vectors, optimism), described

    def described(self, vectors: Floats) -> Floats:
        """(n, k) numbers of candidates (n, columns) that are as far apart as their descriptors, as
        the regression has them; k is at most the number of columns."""
        import numpy as np

        slopes = self._regression()[2:]
        # Distances of `vectors @ slopes` are those of `vectors @ R.T`, where slopes.T = Q R.
        triangle = np.asarray(np.linalg.qr(slopes.T, mode="r"))
        return np.asarray(vectors @ triangle.T)

    def _regression(self) -> Floats:
        """(2 + columns, D) weights of a constant, of failing and of each number of a vector. What
        only failures have, such as where they fail, would otherwise tell safe candidates from
        failures, and safe ones would seem unlike all that is known."""
        import numpy as np

        known = np.concatenate(self._vectors)
        found = np.concatenate([part for part in self._descriptors if part.shape[1]])
        driven = np.concatenate(
            [
                np.isfinite(part).all(axis=1) if part.shape[1] else np.zeros(len(part), bool)
                for part in self._descriptors
            ]
        )
        failed = np.concatenate(self._values)[driven] < 0.0
        base = np.column_stack([np.ones(len(failed)), failed, known[driven]])
        square = base.T @ base + _RIDGE * np.eye(base.shape[1])
        described = found[np.isfinite(found).all(axis=1)]
        return np.asarray(np.linalg.solve(square, base.T @ described))


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
