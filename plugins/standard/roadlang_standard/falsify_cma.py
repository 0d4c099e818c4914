"""`falsify with cma`: an evolution strategy that starts anew where it has found enough."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Axis, Number, Search, Searcher, option

if TYPE_CHECKING:
    import numpy as np

    from roadlang.geometry import Floats


_SMALLEST = 6
"""Points in a generation, at least."""
_STALE = 10
"""Generations without a better point after which a run has stagnated."""


@dataclass(frozen=True)
class Cma(Searcher):
    """CMA-ES (Hansen and Ostermeier 2001) with restarts: the default."""

    name: ClassVar[str] = "cma"
    is_default: ClassVar[bool] = True
    sigma: Number = option(
        0.3, above=0, maximum=1, help="initial standard deviation, in parts of each range"
    )
    restart: Number = option(
        0.25,
        above=0,
        maximum=1,
        help="share of failures in a generation at which the search starts somewhere else",
    )
    spread: Number = option(
        0.5,
        minimum=0,
        maximum=1,
        help="share of generations near failures that were found, to find others unlike them",
    )

    def start(self, axes: Sequence[Axis], seed: int) -> Search:
        return CmaSearch(axes, seed, self)


class CmaSearch(Search):
    """Runs of the strategy one after the other, the first from the middle of the cube, others from
    random points; between them generations of candidates near failures that were found."""

    def __init__(self, axes: Sequence[Axis], seed: int, options: Cma) -> None:
        import numpy as np

        from .cube_encoding import CubeEncoding
        from .failure_spread import FailureSpread

        self._random = np.random.Generator(np.random.Philox(key=seed % 2**64))
        self._encoding = CubeEncoding(axes)
        self._options = options
        self._failures = FailureSpread(self._random)
        self._run: _Run | None = None
        self._is_first = True
        self._owed = 0.0
        self._is_spreading = False
        self._asked: Floats = np.empty((0, self._encoding.columns))

    def ask(self, count: int) -> Floats:
        self._is_spreading = len(self._failures) > 1 and self._owed >= 1.0
        if self._is_spreading:
            self._owed -= 1.0
            self._asked = self._failures.ask(count)
        else:
            self._asked = self._of_run(count)
        self._owed += self._options.spread if len(self._failures) > 1 else 0.0
        return self._encoding.points(self._asked)

    def tell(self, points: Floats, values: Floats, descriptors: Floats) -> None:
        import numpy as np

        if self._is_spreading:
            self._failures.tell(values)
        elif self._run is not None and self._run.tell(self._asked, values, self._options.restart):
            self._run = None
        for row in np.flatnonzero(values < 0.0):
            self._failures.add(self._asked[row], descriptors[row])

    def _of_run(self, count: int) -> Floats:
        """The next generation of the run, or of a new one."""
        import numpy as np

        columns = self._encoding.columns
        if columns < 2:  # the strategy needs two dimensions
            return self._random.random((count, columns))
        if self._run is None:
            start = np.full(columns, 0.5) if self._is_first else self._random.random(columns)
            self._is_first = False
            self._run = _Run(start, self._options.sigma, max(count, _SMALLEST), self._random)
        return self._run.ask(count)


class _Run:
    """One run of the strategy."""

    def __init__(
        self, start: Floats, sigma: float, population: int, random: np.random.Generator
    ) -> None:
        self.population = population
        self._strategy = _strategy(start, sigma, population, random)
        self._told: list[tuple[Floats, float]] = []
        self._best = float("inf")
        self._stale = 0

    def ask(self, count: int) -> Floats:
        """Points of the current generation, which may be requested in parts."""
        import numpy as np

        return np.asarray(self._strategy.ask(count))

    def tell(self, vectors: Floats, values: Floats, restart: float) -> bool:
        """Whether the run is over: it has found enough, or finds nothing better any more."""
        self._told += zip(vectors, values.tolist(), strict=True)
        if len(self._told) < self.population:
            return False
        told = [value for _, value in self._told]
        self._strategy.tell([vector for vector, _ in self._told], told)
        self._told = []
        self._stale = 0 if min(told) < self._best else self._stale + 1
        self._best = min(self._best, *told)
        failing = sum(value < 0.0 for value in told) / len(told)
        return failing >= restart or self._stale >= _STALE or bool(self._strategy.stop())


def _strategy(start: Floats, sigma: float, population: int, random: np.random.Generator) -> Any:
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # that there is no matplotlib for its plots
        import cma
    options = {
        "bounds": [0.0, 1.0],
        "popsize": population,
        "verbose": -9,
        "seed": float("nan"),  # its own seeding is that of numpy's global generator
        "randn": lambda *shape: random.standard_normal(shape),
    }
    return cma.CMAEvolutionStrategy(start, sigma, options)
