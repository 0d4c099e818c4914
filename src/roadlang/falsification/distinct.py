"""Which failures are distinct: of another cause, or of another road or behavior."""

from __future__ import annotations

import numpy as np

from ..geometry.arrays import Floats
from .outcome import Outcome


class DistinctFailures:
    """Failures in the order in which they were found, without those that are like an earlier one.

    Alike are failures of the same cause whose descriptors are at most 1 apart.
    """

    def __init__(self) -> None:
        self.found: list[Outcome] = []
        self._descriptors: dict[str, _Rows] = {}

    def add(self, outcome: Outcome) -> bool:
        """Whether this failure is distinct from all before it; it is kept if so."""
        descriptor = np.array(outcome.descriptor)
        known = self._descriptors.setdefault(outcome.cause, _Rows(len(descriptor)))
        gaps = known.all - descriptor
        if (gaps * gaps).sum(axis=1).min(initial=np.inf) <= 1.0:
            return False
        known.add(descriptor)
        self.found.append(outcome)
        return True


class _Rows:
    """An array that grows row by row: to put hundreds of rows together anew for each failure takes
    longer than to compare them."""

    def __init__(self, columns: int) -> None:
        self._array = np.empty((1, columns))
        self._count = 0

    @property
    def all(self) -> Floats:
        """(n, columns)."""
        return self._array[: self._count]

    def add(self, row: Floats) -> None:
        if self._count == len(self._array):
            self._array = np.concatenate([self._array, np.empty_like(self._array)])
        self._array[self._count] = row
        self._count += 1
