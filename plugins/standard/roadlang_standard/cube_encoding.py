"""Points of the unit cube as vectors for searches that need continuous numbers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from roadlang.api import Axis

from .unit_cube import BELOW_ONE

if TYPE_CHECKING:
    from roadlang.geometry import Floats


MOST_COLUMNS = 40
"""One-hot columns; where there would be more, unordered values are searched as if ordered."""


class CubeEncoding:
    """A column for each axis; for an axis of unordered values one for each value, of which the
    greatest decides (one-hot)."""

    def __init__(self, axes: Sequence[Axis]) -> None:
        unordered = [axis for axis in axes if axis.ends is not None and not axis.is_ordered]
        fits = sum(len(axis.middles()) for axis in unordered) <= MOST_COLUMNS
        self._middles = [
            axis.middles() if fits and axis in unordered and len(axis.middles()) > 1 else ()
            for axis in axes
        ]
        self.columns = sum(len(middles) or 1 for middles in self._middles)

    def points(self, vectors: Floats) -> Floats:
        """The points (n, axes) that vectors (n, columns) of numbers in [0, 1] stand for."""
        import numpy as np

        points = np.empty((len(vectors), len(self._middles)))
        start = 0
        for axis, middles in enumerate(self._middles):
            width = len(middles) or 1
            part = vectors[:, start : start + width]
            points[:, axis] = np.asarray(middles)[part.argmax(axis=1)] if middles else part[:, 0]
            start += width
        return np.clip(points, 0.0, BELOW_ONE)

    def choices(self, vectors: Floats) -> Floats:
        """(n, c) which unordered values vectors stand for: 1 for the value that is chosen, 0 for
        the others; c is 0 where there are none."""
        import numpy as np

        found = [np.empty((len(vectors), 0))]
        start = 0
        for middles in self._middles:
            width = len(middles) or 1
            if middles:
                chosen = vectors[:, start : start + width].argmax(axis=1)
                found.append((np.arange(width) == chosen[:, None]).astype(np.float64))
            start += width
        return np.concatenate(found, axis=1)

    def vectors(self, points: Floats) -> Floats:
        """Vectors that stand for points: the value that is chosen has 0.75, the others 0.25."""
        import numpy as np

        columns = []
        for axis, middles in enumerate(self._middles):
            column = points[:, axis : axis + 1]
            if middles:
                nearest = np.abs(column - np.asarray(middles)).argmin(axis=1)
                column = np.where(np.arange(len(middles)) == nearest[:, None], 0.75, 0.25)
            columns.append(column)
        return np.concatenate([*columns, np.empty((len(points), 0))], axis=1)
