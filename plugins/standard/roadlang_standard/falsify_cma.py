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
_STALE = 20
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

    def start(self, axes: Sequence[Axis], seed: int) -> Search:
        return CmaSearch(axes, seed, self.sigma, self.restart)


class CmaSearch(Search):
    """A sequence of runs: the first from the middle of the cube, others from random points."""

    def __init__(self, axes: Sequence[Axis], seed: int, sigma: float, restart: float) -> None:
        import numpy as np

        from .cube_encoding import CubeEncoding

        self._random = np.random.Generator(np.random.Philox(key=seed % 2**64))
        self._encoding = CubeEncoding(axes)
        self._sigma = sigma
        self._restart = restart
        self._runs = 0
        self._run: _Run | None = None
        self._asked: Floats = np.empty((0, self._encoding.columns))

    def ask(self, count: int) -> Floats:
        if self._run is None:
            self._run = self._start_run(max(count, _SMALLEST))
        self._asked = self._run.ask(count)
        return self._encoding.points(self._asked)

    def tell(self, points: Floats, values: Floats, descriptors: Floats) -> None:
        if self._run is not None and self._run.tell(self._asked, values, self._restart):
            self._run = None

    def _start_run(self, population: int) -> _Run:
        import numpy as np

        columns = self._encoding.columns
        start = self._random.random(columns) if self._runs else np.full(columns, 0.5)
        self._runs += 1
        return _Run(start, self._sigma, population, self._random)


class _Run:
    """One run of the strategy; generations may be asked for in parts."""

    def __init__(
        self, start: Floats, sigma: float, population: int, random: np.random.Generator
    ) -> None:
        self._random = random
        self._population = population
        self._strategy = _strategy(start, sigma, population, random) if len(start) > 1 else None
        self._columns = len(start)
        self._told: list[tuple[Floats, float]] = []
        self._best = float("inf")
        self._stale = 0

    def ask(self, count: int) -> Floats:
        import numpy as np

        if self._strategy is None:  # it needs two dimensions
            return self._random.random((count, self._columns))
        return np.asarray(self._strategy.ask(count)).reshape(count, self._columns)

    def tell(self, vectors: Floats, values: Floats, restart: float) -> bool:
        """Whether the run is over: it has found enough, or finds nothing better any more."""
        self._told += zip(vectors, values.tolist(), strict=True)
        if self._strategy is None or len(self._told) < self._population:
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
