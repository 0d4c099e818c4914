"""Candidates in small steps off the safe drives that came nearest to failing."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_PARENTS = 2
"""How many there are at a time."""
_ON_LINE = 0.3
"""Share of children on the line between two parents."""
_LEAST_STEP, _MOST_STEP = 0.02, 0.15
"""Of the normal steps that children take, as a fraction of each range."""
_PATIENCE = 3
"""Batches without a better candidate after which the best is given up, with all around it."""


class NearMisses:
    """Some safe candidates of least value, whose children lead to a first failure, or are given up
    where they lead no further. `apart`: how far others are from what is given up (root mean square
    over the columns)."""

    def __init__(self, random: np.random.Generator, apart: float) -> None:
        self._random = random
        self._apart = apart
        self._given_up: list[Floats] = []
        self._parents: list[Floats] = []
        self._best = float("inf")
        self._fruitless = 0

    def tell(self, safe: Sequence[tuple[float, Floats]]) -> None:
        """All safe candidates (value, vector) after a batch, the best first; at least one."""
        best = self._choose(safe)
        self._fruitless = 0 if best < self._best else self._fruitless + 1
        if self._fruitless >= _PATIENCE:
            self._given_up.append(self._parents[0])
            self._fruitless = 0
            best = self._choose(safe)
        self._best = best

    def children(self, count: int) -> Floats:
        """(count, columns) vectors, which may lie beyond 0 and 1."""
        import numpy as np

        random, parents = self._random, np.stack(self._parents)
        child, other = (parents[random.integers(len(parents), size=count)] for _ in range(2))
        on_line = child + random.random((count, 1)) * (other - child)
        child = np.where(random.random((count, 1)) < _ON_LINE, on_line, child)
        step = _LEAST_STEP * (_MOST_STEP / _LEAST_STEP) ** random.random((count, 1))
        return np.asarray(child + step * random.standard_normal(child.shape))

    def _choose(self, safe: Sequence[tuple[float, Floats]]) -> float:
        """Take the parents, all of them again where all is given up; the value of the best."""
        rest = (pair for pair in safe if not self._is_given_up(pair[1]))
        chosen = list(islice(rest, _PARENTS))
        if not chosen:
            self._given_up = []
            chosen = list(safe[:_PARENTS])
        self._parents = [vector for _, vector in chosen]
        return chosen[0][0]

    def _is_given_up(self, vector: Floats) -> bool:
        gaps = (float(((vector - other) ** 2).mean()) for other in self._given_up)
        return any(gap <= self._apart**2 for gap in gaps)
