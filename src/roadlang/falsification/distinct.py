"""Which failures are distinct: of another cause, or of another road or behavior."""

from __future__ import annotations

from collections import defaultdict

import numpy as np

from ..geometry.arrays import Floats
from .outcome import Outcome


class DistinctFailures:
    """Failures in the order in which they were found, without those that are like an earlier one.

    Alike are failures of the same cause whose descriptors are at most 1 apart.
    """

    def __init__(self) -> None:
        self.found: list[Outcome] = []
        self._descriptors: dict[str, list[Floats]] = defaultdict(list)

    def add(self, outcome: Outcome) -> bool:
        """Whether this failure is distinct from all before it; it is kept if so."""
        known = self._descriptors[outcome.cause]
        descriptor = np.array(outcome.descriptor)
        if known:
            gaps = np.stack(known) - descriptor
            if (gaps * gaps).sum(axis=1).min(initial=np.inf) <= 1.0:
                return False
        known.append(descriptor)
        self.found.append(outcome)
        return True
