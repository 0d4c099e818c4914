"""Candidates near failures that are known, to find others that are unlike them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from .failure_model import FailureModel, squares_apart

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_POOL = 40
"""Children made for each that is chosen."""
_LEAST_STEP, _MOST_STEP = 0.03, 0.4
"""Of the normal steps that children take, in parts of each range."""
_ON_LINE, _CROSSED = 0.3, 0.3
"""Shares of children on the line between two failures, and mixed of two (uniform crossover)."""
_APART = 1.3
"""How far from all failures a child should be: further than 1 is distinct."""
_ALIKE = 3.0
"""What a child loses in value that is like a failure; the best value is below 0, the worst 1."""


class FailureSpread:
    """Distinct failures and their offspring, of which a model of what was evaluated so far chooses
    those that should fail, each unlike all others (surrogate-assisted illumination: Gaier, Asteroth
    and Mouret 2018, without the grid of cells: distances of descriptors count)."""

    def __init__(self, random: np.random.Generator, choices: Callable[[Floats], Floats]) -> None:
        """`choices`: (n, c) the unordered values that vectors stand for; failures with others are
        unlike each other."""
        self._random = random
        self._choices = choices
        self._parents: list[Floats] = []
        self._descriptors: list[Floats] = []
        self._model = FailureModel()

    def __len__(self) -> int:
        return len(self._parents)

    def tell(self, vectors: Floats, values: Floats, descriptors: Floats) -> None:
        """What came of candidates, these or others: (n, columns), (n,), (n, D)."""
        import numpy as np

        self._model.tell(vectors, values, descriptors)
        descriptors = np.column_stack([descriptors, self._choices(vectors)])
        for row in np.flatnonzero(values < 0.0):
            if self._descriptors:
                gaps = np.stack(self._descriptors) - descriptors[row]
                if (gaps * gaps).sum(axis=1).min() <= 1.0:
                    continue
            self._parents.append(vectors[row])
            self._descriptors.append(descriptors[row])

    def ask(self, count: int) -> Floats:
        """(count, columns) vectors in [0, 1]; there has to be a failure."""
        import numpy as np

        children = self._children(_POOL * count)
        values, predicted = self._model.predicted(children)
        descriptors = np.column_stack([predicted, self._choices(children)])
        nearest = squares_apart(descriptors, np.stack(self._descriptors)).min(axis=1)
        chosen = []
        for _ in range(count):
            lacking = np.maximum(_APART - np.sqrt(nearest), 0.0)
            best = int((values + _ALIKE * lacking).argmin())
            chosen.append(best)
            off = squares_apart(descriptors, descriptors[best : best + 1])[:, 0]
            nearest = np.minimum(nearest, off)
            values[best] = np.inf
        return children[chosen]

    def _children(self, count: int) -> Floats:
        import numpy as np

        random, parents = self._random, np.stack(self._parents)
        child = parents[random.integers(len(parents), size=count)]
        other = parents[random.integers(len(parents), size=count)]
        choice = random.random((count, 1))
        on_line = child + random.random((count, 1)) * (other - child)
        crossed = np.where(random.random(child.shape) < 0.5, other, child)
        child = np.where(choice < _ON_LINE, on_line, child)
        child = np.where((choice >= _ON_LINE) & (choice < _ON_LINE + _CROSSED), crossed, child)
        step = _LEAST_STEP * (_MOST_STEP / _LEAST_STEP) ** random.random((count, 1))
        child = child + step * random.standard_normal(child.shape)
        return np.asarray(1.0 - np.abs(np.mod(child, 2.0) - 1.0))
