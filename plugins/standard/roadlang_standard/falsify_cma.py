"""`falsify with cma`: an evolution strategy that starts anew where it has found enough."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Axis, Number, Search, Searcher, option

if TYPE_CHECKING:
    import numpy as np

    from roadlang.geometry import Floats

    from .failure_spread import FailureSpread


_FIRST_BATCH, _GROWTH = 11, 6
"""Candidates in the first batches, and how many more for each distinct failure that is known."""
_SHARE = 1 / 30
"""Least size of a batch, as a share of all candidates so far: where failures are rare, a search
then does not consist of very many small batches. Until something fails, forgotten candidates do not
count: a search that starts over learns from small batches again."""
_SMALLEST = 6
"""Points in a generation, at least."""
_ROUNDS = 6
"""How often candidates are drawn until there are enough that satisfy the requirements."""
_STALE = 10
"""Generations without a better point after which a run has stagnated."""
_FRUITLESS = 500
"""Evaluations without a failure after which all that is known is forgotten. Until then a failure in
the next hundred becomes no less likely; a search that has found none by then is near safe drives
from which none can be reached, and seldom leaves them."""


@dataclass(frozen=True)
class Cma(Searcher):
    """CMA-ES (Hansen and Ostermeier 2001) with restarts, and a model of the robustness of
    evaluated candidates: the default. It begins with random candidates. Until something fails,
    half of each batch is near the two drives that came nearest to failing (or near others, if
    three batches find nothing better), and half where the model expects that a failure is still
    possible. After 500 evaluations without a failure it discards them and starts over. After the
    first failure, candidates are near failures, and each is unlike the known ones. The model
    compares roads by their bends, wherever along the road these are, and all draws by their
    values. Most candidates that violate a requirement are replaced before they are evaluated,
    which is much cheaper than a drive; they are not counted. CMA-ES leads to scenes that satisfy
    the requirements if none is found at random; the model chooses the share `spread` of the
    candidates, CMA-ES the rest."""

    name: ClassVar[str] = "cma"
    also_called: ClassVar[tuple[str, ...]] = ("cma_es", "cmaes", "evolution")
    is_default: ClassVar[bool] = True
    sigma: Number = option(
        0.3, above=0, maximum=1, help="initial standard deviation, as a fraction of each range"
    )
    restart: Number = option(
        0.03,
        above=0,
        maximum=1,
        help="share of failures in a generation at which the search starts somewhere else",
    )
    spread: Number = option(
        1.0,
        minimum=0,
        maximum=1,
        help="share of candidates near those that failed or came nearest to failing; a model of "
        "all evaluations chooses them to differ from known failures",
    )

    def start(self, axes: Sequence[Axis], seed: int) -> Search:
        return CmaSearch(axes, seed, self)


class CmaSearch(Search):
    """Random candidates that satisfy the requirements, until some were driven. From then on a share
    of each batch (by default all) is spread around failures and the safe candidates that came
    nearest to failing. The rest, and what no random candidate is found for, come of runs of the
    strategy, each with half of a batch as its generation; the first begins in the middle of the
    cube, all others at random points, and what is over is replaced."""

    def __init__(self, axes: Sequence[Axis], seed: int, options: Cma) -> None:
        import numpy as np

        from .cube_encoding import CubeEncoding

        self._random = np.random.Generator(np.random.Philox(key=seed % 2**64))
        self._encoding = CubeEncoding(axes)
        self._options = options
        self._screen: Callable[[Floats], Floats] = _unscreened
        self._spread = self._new_spread()
        self._runs: list[_Run] = []
        self._started = 0
        self._population = 0
        self._told = 0
        self._begun = 0
        """how much was told before there were parents, or since all were forgotten"""
        self._pending: list[tuple[_Run | FailureSpread, Floats]] = []

    def screen_with(self, screen: Callable[[Floats], Floats]) -> None:
        self._screen = screen

    def batch_size(self, most: int) -> int:
        known = _FIRST_BATCH + _GROWTH * len(self._spread)
        told = self._told if len(self._spread) else self._told - self._begun
        return min(most, max(known, round(_SHARE * told)))

    def ask(self, count: int) -> Floats:
        import numpy as np

        columns = self._encoding.columns
        self._pending = []
        if columns < 2:  # the strategy needs two dimensions
            return self._encoding.points(self._random.random((count, columns)))
        self._population = self._population or max(_SMALLEST, round(0.5 * count))
        share = round(count * self._options.spread)
        if share:
            spread = self._around(share)
            self._pending.append((self._spread, spread))
            count -= len(spread)
        number = 0
        while count > 0:
            if number == len(self._runs):
                self._runs.append(self._new_run())
            run = self._runs[number]
            self._pending.append((run, run.ask(min(count, run.rest))))
            count -= len(self._pending[-1][1])
            number += 1
        return self._encoding.points(np.concatenate([vectors for _, vectors in self._pending]))

    def tell(self, points: Floats, values: Floats, descriptors: Floats) -> None:
        first = 0
        self._told += len(values)
        for source, vectors in self._pending:
            part = slice(first, first + len(vectors))
            first = part.stop
            restart = self._options.restart
            if isinstance(source, _Run) and source.tell(vectors, values[part], restart):
                self._runs.remove(source)
            self._spread.tell(vectors, values[part], descriptors[part])
        if not self._spread.has_parents:
            self._begun = self._told

    def _around(self, count: int) -> Floats:
        """At most `count` vectors around failures and near misses. While there are none, or after
        a long time without a failure, they are random: where a search ends up depends on where it
        began."""
        if not self._spread.has_parents:
            return self._drawn(count)
        if len(self._spread) or self._told - self._begun < _FRUITLESS:
            return self._spread.ask(count)
        self._begun = self._told
        drawn = self._drawn(count)
        if len(drawn) < count:  # what the strategy has led to would not be found again
            return self._spread.ask(count)
        self._spread = self._new_spread()
        return drawn

    def _drawn(self, count: int) -> Floats:
        """At most `count` random vectors that satisfy the requirements."""
        import numpy as np

        found = np.empty((0, self._encoding.columns))
        for _ in range(_ROUNDS):
            drawn = self._random.random((2 * count, self._encoding.columns))
            found = np.concatenate([found, drawn[self._screened(drawn) < 1.0]])[:count]
            if len(found) == count:
                break
        return found

    def _screened(self, vectors: Floats) -> Floats:
        return self._screen(self._encoding.points(vectors))

    def _new_spread(self) -> FailureSpread:
        from .failure_spread import FailureSpread

        return FailureSpread(self._random, self._encoding.choices, self._screened)

    def _new_run(self) -> _Run:
        import numpy as np

        columns = self._encoding.columns
        start = self._random.random(columns) if self._started else np.full(columns, 0.5)
        self._started += 1
        return _Run(start, self._options.sigma, self._population, self._random)


def _unscreened(points: Floats) -> Floats:
    """Every point may satisfy the requirements, where nothing can tell."""
    import numpy as np

    return np.zeros(len(points))


class _Run:
    """One run of the strategy."""

    def __init__(
        self, start: Floats, sigma: float, population: int, random: np.random.Generator
    ) -> None:
        self.population = population
        self._strategy = _strategy(start, sigma, population, random)
        self._evaluated: list[tuple[Floats, float]] = []
        self._best = float("inf")
        self._stale = 0

    @property
    def rest(self) -> int:
        """Points that the current generation still lacks."""
        return self.population - len(self._evaluated)

    def ask(self, count: int) -> Floats:
        """Points of the current generation, which may be requested in parts."""
        import numpy as np

        return np.asarray(self._strategy.ask(count))

    def tell(self, vectors: Floats, values: Floats, restart: float) -> bool:
        """Whether the run is over: it has found enough, or finds nothing better any more."""
        self._evaluated += zip(vectors, values.tolist(), strict=True)
        if len(self._evaluated) < self.population:
            return False
        values_so_far = [value for _, value in self._evaluated]
        self._strategy.tell([vector for vector, _ in self._evaluated], values_so_far)
        self._evaluated = []
        self._stale = 0 if min(values_so_far) < self._best else self._stale + 1
        self._best = min(self._best, *values_so_far)
        failing = sum(value < 0.0 for value in values_so_far) / len(values_so_far)
        return failing >= restart or self._stale >= _STALE or bool(self._strategy.stop())


def _strategy(start: Floats, sigma: float, population: int, random: np.random.Generator) -> Any:
    cma = _library()
    options = {
        "bounds": [0.0, 1.0],
        "popsize": population,
        "verbose": -9,
        "seed": float("nan"),  # its own seeding is that of numpy's global generator
        "randn": lambda *shape: random.standard_normal(shape),
    }
    return cma.CMAEvolutionStrategy(start, sigma, options)


@cache
def _library() -> Any:
    """The package `cma` without `scipy.stats`, which takes half a second to load and is optional:
    `cma` uses it only to compare surrogate models of the objective, which we do not have."""
    import sys
    import warnings

    unloaded = "scipy.stats" not in sys.modules
    if unloaded:
        sys.modules["scipy.stats"] = None  # type: ignore[assignment]  # an import of it fails
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # about matplotlib, which its plots need
            import cma
    finally:
        if unloaded:
            del sys.modules["scipy.stats"]
    return cma
