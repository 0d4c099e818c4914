"""A model of drives by the bends of their roads, wherever along the road these are."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from .learned_kernel import Kernel

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Singles = NDArray[np.float32]

_PLACES, _STRIDE = 12, 4
"""Of a window along the road, and from one window to the next."""
_PATTERNS = 128
"""Random patterns that windows are compared with."""
_WIDTH = 0.35
"""How little a pattern responds to: a part of what it has of a window of usual curvature."""
_OTHERS = 0.5
"""The part that all other draws have in how far candidates are apart."""
_MEDIAN = 0.5
"""The value far from everything: that of a usual safe drive, as values are scores of ranks."""
_LEAST = 1e-9
_AT_ONCE = 64
"""Roads whose responses are computed together: these fit into the caches."""


class BendModel:
    """Gaussian process of values by the bends of roads.

    Windows of 12 places slide along a road; each of 128 patterns of random weights p responds to
    the curvature w of a window with 1 / (1 + (p w)^2). The means of the responses over the windows
    describe the road (mean embedding: Muandet and others 2017, section 3; random features: Rahimi
    and Recht 2007). They are the same for the same bends elsewhere, or turned the other way."""

    def __init__(self) -> None:
        import numpy as np

        random = np.random.Generator(np.random.Philox(key=0))
        self._patterns = random.standard_normal((_PLACES, _PATTERNS))
        self._kernel = Kernel(_MEDIAN)
        self._responses = np.empty((0, 0), np.float32)
        self._center = np.empty(0)
        self._scale = 0.0
        self._windows = 0
        self.is_fit = False
        """whether what it was told last had roads that differ"""

    def fit(self, vectors: Floats, others: Floats, road: Floats, values: Floats) -> None:
        """Learn from vectors (n, columns), also as `others` (n, c), of which two are usually 1
        apart, with values (n,). `road`: (1 + columns, places) the curvature of a road, linear in a
        constant and its vector."""
        import numpy as np

        curvature = road[0] + vectors @ road[1:]
        usual = float(curvature.std()) * _WIDTH * _PLACES**0.5
        self.is_fit = usual > _LEAST
        if not self.is_fit:
            return
        starts = range(0, road.shape[1] - _PLACES + 1, _STRIDE)
        windows = np.stack([road[:, start : start + _PLACES] for start in starts], axis=1)
        responses = (windows @ (self._patterns / usual)).reshape(len(road), -1)
        self._windows = len(starts)
        self._responses = responses.astype(np.float32)
        embedded = self._embedded(vectors)
        self._center = embedded.mean(axis=0)
        spread = float(np.sqrt(2.0 * embedded.var(axis=0).sum()))
        self._scale = (1.0 - _OTHERS) ** 0.5 / max(spread, _LEAST)
        self._kernel.fit(self._joined(embedded, others), values)

    def predicted(self, vectors: Floats, others: Floats, optimism: float) -> Floats:
        """(n,) values of vectors, less `optimism` times their standard deviation, by the last
        fit."""
        import numpy as np

        points = np.empty((len(vectors), _PATTERNS + others.shape[1]), np.float32)
        for part, embedded in self._embedded_parts(vectors):  # still in the caches
            points[part] = self._joined(embedded, others[part])
        return self._kernel.predicted(points, optimism)

    def _embedded(self, vectors: Floats) -> Floats:
        """(n, patterns) mean responses of the roads of vectors."""
        import numpy as np

        found = np.empty((len(vectors), _PATTERNS))
        for part, embedded in self._embedded_parts(vectors):
            found[part] = embedded
        return found

    def _embedded_parts(self, vectors: Floats) -> Iterator[tuple[slice, Singles]]:
        """The same of some vectors after the others."""
        import numpy as np

        known = np.column_stack([np.ones(len(vectors)), vectors]).astype(np.float32)
        mean = np.full(self._windows, 1.0 / self._windows, np.float32)
        for first in range(0, len(vectors), _AT_ONCE):
            part = slice(first, first + _AT_ONCE)
            response = known[part] @ self._responses
            response *= response
            response += 1.0
            np.reciprocal(response, out=response)
            yield part, mean @ response.reshape(len(response), self._windows, -1)

    def _joined(self, embedded: Floats | Singles, others: Floats) -> Floats:
        import numpy as np

        joined = np.empty((len(embedded), embedded.shape[1] + others.shape[1]))
        bends = np.subtract(embedded, self._center, out=joined[:, : embedded.shape[1]])
        bends *= self._scale
        np.multiply(others, _OTHERS**0.5, out=joined[:, embedded.shape[1] :])
        return joined
