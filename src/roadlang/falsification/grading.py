"""One number for each outcome, by which searches go on: requirements first, then expectations."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..geometry.arrays import Floats
from ..judging.badness import says_how_near
from .outcome import Outcome

_LEAST = 1e-12


class Grading:
    """From 1 where a requirement is violated, by how much; from 0 to 1 where all expectations hold;
    below 0 where one is violated, the lower the more important it is and the worse it fails.

    Robustness has units: it is measured in the median that the first valid candidates have.
    `names`: the expectations, the most important first.
    """

    def __init__(self, names: Sequence[str]) -> None:
        self._names = tuple(names)
        self._scales: dict[str, float] = {}

    def values(self, outcomes: Sequence[Outcome]) -> Floats:
        """(n,) the value of each. Batches have to come in the order of the search: the first with a
        finite robustness sets the scale."""
        self._learn(outcomes)
        return np.array([self._value(outcome) for outcome in outcomes])

    def _learn(self, outcomes: Sequence[Outcome]) -> None:
        for name in self._names:
            if name not in self._scales:
                sizes = [abs(r) for o in outcomes if (r := o.expectations.get(name)) is not None]
                if sizes:
                    self._scales[name] = max(float(np.median(sizes)), _LEAST)

    def _value(self, outcome: Outcome) -> float:
        if outcome.violation is not None:
            return 1.0 + outcome.violation
        for rank, name in enumerate(self._names):
            if name in outcome.violated:
                return -float(len(self._names) - rank - 1) - self._size(name, outcome)
        return min((self._size(name, outcome) for name in self._names), default=1.0 - _LEAST)

    def _size(self, name: str, outcome: Outcome) -> float:
        """Robustness or its lack, from 0 to 1, without either: infinite robustness is 1, and so is
        that of an equality that holds, lest it hide how near the other expectations came."""
        robustness = outcome.expectations.get(name)
        if robustness is None or not says_how_near(name not in outcome.violated, robustness):
            return 1.0 - _LEAST
        size = abs(robustness) / self._scales[name]
        return float(np.clip(size / (1.0 + size), _LEAST, 1.0 - _LEAST))
