"""Candidates near failures that are known, to find others that are unlike them."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_STEP, _LEAST_STEP, _MOST_STEP = 0.12, 0.02, 0.5
_GOOD_SHARE = 0.3
"""Share of failures among moved candidates at which the length of moves stays as it is."""
_ON_LINE, _CROSSED = 0.5, 0.25
"""Shares of candidates between two failures and mixed of two; the others move away from one."""
_JITTER = 0.05
"""Step that candidates of two failures take as well."""


class FailureSpread:
    """An archive of distinct failures. Those that were used least get offspring: on the line to
    another, mixed with another (uniform crossover), or moved by normal steps, whose length
    adapts."""

    def __init__(self, random: np.random.Generator) -> None:
        self._random = random
        self._parents: list[Floats] = []
        self._descriptors: list[Floats] = []
        self._offspring: list[int] = []
        self._step = _STEP
        self._moved: list[bool] = []

    def __len__(self) -> int:
        return len(self._parents)

    def add(self, vector: Floats, descriptor: Floats) -> None:
        """Add a failure, unless it is like one that is there."""
        import numpy as np

        if self._descriptors:
            gaps = np.stack(self._descriptors) - descriptor
            if (gaps * gaps).sum(axis=1).min() <= 1.0:
                return
        self._parents.append(vector)
        self._descriptors.append(descriptor)
        self._offspring.append(0)

    def ask(self, count: int) -> Floats:
        """(count, columns) vectors in [0, 1]; there has to be a failure."""
        import numpy as np

        vectors = [self._child() for _ in range(count)]
        return np.stack(vectors)

    def tell(self, values: Floats) -> None:
        """Take the results of the last vectors; the step length adapts."""
        import numpy as np

        moved = np.array(self._moved[: len(values)], dtype=bool)
        if moved.any():
            share = float((values[moved] < 0.0).mean())
            self._step *= float(np.exp(0.5 * (share - _GOOD_SHARE)))
            self._step = min(max(self._step, _LEAST_STEP), _MOST_STEP)
        self._moved = []

    def _child(self) -> Floats:
        import numpy as np

        random = self._random
        least = min(self._offspring)
        parents = [i for i, count in enumerate(self._offspring) if count <= least]
        chosen = parents[int(random.integers(len(parents)))]
        self._offspring[chosen] += 1
        child = self._parents[chosen].copy()
        other = self._parents[int(random.integers(len(self._parents)))]
        way = random.random()
        if way < _ON_LINE:
            child = child + random.random() * (other - child)
        elif way < _ON_LINE + _CROSSED:
            child = np.where(random.random(len(child)) < 0.5, other, child)
        is_moved = way >= _ON_LINE + _CROSSED
        self._moved.append(is_moved)
        step = self._step if is_moved else _JITTER
        child = child + step * random.standard_normal(len(child))
        return np.asarray(1.0 - np.abs(np.mod(child, 2.0) - 1.0))
