"""Candidates near failures that are known and near the safe drives that came nearest to failing."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from .failure_model import FailureModel
from .learned_kernel import squares_apart
from .near_misses import NearMisses

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Integers = NDArray[np.intp]

_POOL, _SHORTLIST = 24, 12
"""Children made, and looked at more closely, for each that is chosen."""
_LEAST_SHORTLIST = 1000
"""Children looked at more closely, at least: near some failures hardly any satisfy the
requirements."""
_LEAST_POOL, _MANY = 16000, 60
"""Children made, at least, until that many distinct failures are known: where failures are rare,
few children both fail and are unlike all that is known."""
_LEAST_AT_FIRST = 1500
"""The same of both halves of a batch, until something fails."""
_ROUNDS = 6
"""How often children that violate a requirement are replaced by others."""
_ELITE, _FEWEST = 40, 10
"""Safe candidates that are parents: the greatest number, and that with which it begins."""
_REMEMBERED, APART = 400, 0.12
"""Safe candidates that may become parents, and how far parents are apart (root mean square over the
columns) until something fails: without it all soon are the neighbors of one, from which no failure
may be reached."""
_OPTIMISM = 3.0
"""Standard deviations of the model by which values may be better than it has them, until something
fails: what is unknown is tried before what is known to be nearly good enough. With 0 a
search stays near what it knows, and takes more than twice as long."""
_RECENT = 400
"""Failures of which differences are taken: the latest."""
_LEAST_STEP, _MOST_STEP = 0.03, 0.4
"""Of the normal steps that children take, as a fraction of each range."""
_ON_LINE, _CROSSED = 0.3, 0.3
"""Shares of children on the line between two parents, and mixed of two (uniform crossover)."""
_DIFFERENT = 0.3
"""Share of the children that lie off a failure by the difference of two others."""
_MOST_DIFFERENCE, _NEIGHBORS, _NOISE = 2.5, 30, 0.02
"""The greatest multiple of the difference, how many neighbors it is of, normal steps beside it."""
_UNLIKE = (1.03, 3.5)
"""How far from all failures a child should be (further than 1 is distinct), and what it loses in
value for what it lacks; the best value is below 0, the worst 1."""
_UNLIKE_AT_FIRST = (0.5, 0.3)
"""The same while there are fewer failures than `_FEWEST`: to find some comes before variety."""


class FailureSpread:
    """Distinct failures, the safe candidates of least robustness, and their offspring, of which a
    model of what was evaluated so far chooses those that should fail, each unlike all failures
    (surrogate-assisted illumination: Gaier, Asteroth and Mouret 2018, without the grid of cells:
    distances of descriptors count)."""

    def __init__(
        self,
        random: np.random.Generator,
        choices: Callable[[Floats], Floats],
        screen: Callable[[Floats], Floats],
    ) -> None:
        """`choices`: (n, c) the unordered values that vectors stand for; failures with others are
        unlike each other. `screen`: (n,) from 1 on for vectors that violate a requirement."""
        self._random = random
        self._choices = choices
        self._screen = screen
        self._distinct: list[Floats] = []
        self._descriptors: list[Floats] = []
        self._failures: list[Floats] = []
        self._safe: list[tuple[float, Floats]] = []
        self._elite: list[Floats] = []
        self._near_misses = NearMisses(random, APART)
        self._model = FailureModel()

    def __len__(self) -> int:
        """How many distinct failures are known."""
        return len(self._distinct)

    @property
    def has_parents(self) -> bool:
        """Whether enough is known to ask for candidates."""
        return bool(self._failures) or len(self._safe) >= _FEWEST

    @property
    def _is_variety(self) -> bool:
        """Whether failures unlike those that are known are looked for: to find some comes first."""
        return len(self._failures) >= _FEWEST

    def tell(self, vectors: Floats, values: Floats, descriptors: Floats) -> None:
        """What came of candidates, these or others: (n, columns), (n,), (n, D)."""
        import numpy as np

        self._model.tell(vectors, values, descriptors)
        safe = np.flatnonzero((values >= 0.0) & (values < 1.0)).tolist()
        self._safe += [(float(values[row]), vectors[row]) for row in safe]
        self._safe = sorted(self._safe, key=lambda pair: pair[0])[:_REMEMBERED]
        if self._safe and not self._failures:
            self._near_misses.tell(self._safe)
        failing = np.flatnonzero(values < 0.0)
        self._failures = [*self._failures, *vectors[failing]][-_RECENT:]
        descriptors = np.column_stack([descriptors, self._choices(vectors)])[failing]
        nearest = np.full(len(failing), np.inf)
        if self._descriptors:
            nearest = squares_apart(descriptors, np.stack(self._descriptors)).min(axis=1)
        for number, row in enumerate(failing):
            if nearest[number] > 1.0:
                self._distinct.append(vectors[row])
                self._descriptors.append(descriptors[number])
                nearest = np.minimum(nearest, _squares_from(descriptors, number))
        best = [vector for _, vector in self._safe]
        self._elite = best[:_ELITE] if self._failures else one_of_each_neighborhood(best)

    def ask(self, count: int) -> Floats:
        """(count, columns) vectors in [0, 1]; there have to be parents."""
        import numpy as np

        self._model.fit()
        if self._failures:
            return self._chosen(self._children(self._pool(count)), count, 0.0)
        close = count // 2
        far = self._chosen(self._children(self._pool(count - close)), count - close, _OPTIMISM)
        children = _reflected(self._near_misses.children(self._pool(close)))
        return np.concatenate([far, self._chosen(children, close, 0.0)])

    def _pool(self, count: int) -> int:
        """How many children are made for `count` that are chosen."""
        if not self._failures:
            return max(_POOL * count, _LEAST_AT_FIRST)
        return max(_POOL * count, _LEAST_POOL if len(self._distinct) < _MANY else 0)

    def _chosen(self, children: Floats, count: int, optimism: float) -> Floats:
        """(count, columns): of children those that should fail, unlike each other."""
        import numpy as np

        values, predicted = self._model.predicted(children, optimism)
        descriptors = np.column_stack([predicted, self._choices(children)])
        nearest, unlike = np.full(len(children), np.inf), _UNLIKE_AT_FIRST
        if self._is_variety:
            # As the model has them too: what it cannot tell makes nothing unlike.
            failures = np.stack(self._distinct)
            known = np.column_stack([self._model.described(failures), self._choices(failures)])
            nearest = squares_apart(descriptors, known).min(axis=1)
            unlike = _UNLIKE
        most = max(_SHORTLIST * count, _LEAST_SHORTLIST)
        best = np.argsort(values + _loss(nearest, unlike), kind="stable")[:most]
        shortlist = _Shortlist(values[best], descriptors[best], nearest[best], unlike)
        return children[best[self._valid(children[best], shortlist, count)]]

    def _valid(self, children: Floats, shortlist: _Shortlist, count: int) -> list[int]:
        """The rows of `count` children that satisfy the requirements, as far as some rounds find
        as many, and others; fewer where none are left."""
        chosen: list[int] = []
        for number in range(_ROUNDS):
            lack = count - len(chosen)
            rows = shortlist.take(lack << number)  # more, the fewer hold
            is_valid = self._screen(children[rows]) < 1.0
            valid = [row for row, holds in zip(rows, is_valid.tolist(), strict=True) if holds]
            shortlist.keep_apart(valid[:lack])
            chosen += valid[:lack]
            if len(chosen) == count or not rows:
                return chosen
        return chosen + shortlist.take(count - len(chosen))

    def _children(self, count: int) -> Floats:
        import numpy as np

        different = round(_DIFFERENT * count) if len(self._failures) >= _FEWEST else 0
        children = self._varied(count - different)
        if different:
            children = np.concatenate([self._differing(different), children])
        return _reflected(children)

    def _varied(self, count: int) -> Floats:
        """Children of one parent or of two, in steps of many sizes."""
        import numpy as np

        random = self._random
        # The first failures have as many children as all that nearly failed.
        times = max(1, len(self._elite) // max(1, len(self._distinct)))
        parents = np.stack([*(self._distinct * times), *self._elite])
        child = parents[random.integers(len(parents), size=count)]
        other = parents[random.integers(len(parents), size=count)]
        choice = random.random((count, 1))
        on_line = child + random.random((count, 1)) * (other - child)
        crossed = np.where(random.random(child.shape) < 0.5, other, child)
        child = np.where(choice < _ON_LINE, on_line, child)
        child = np.where((choice >= _ON_LINE) & (choice < _ON_LINE + _CROSSED), crossed, child)
        step = _LEAST_STEP * (_MOST_STEP / _LEAST_STEP) ** random.random((count, 1))
        return np.asarray(child + step * random.standard_normal(child.shape))

    def _differing(self, count: int) -> Floats:
        """Failures, moved as failures near them differ from each other: along the directions in
        which it goes on failing (differential evolution: Storn and Price 1997)."""
        import numpy as np

        random, failures = self._random, np.stack(self._failures)
        base = np.stack(self._distinct if len(self._distinct) >= _FEWEST else self._failures)
        near = np.argsort(squares_apart(base, failures), axis=1, kind="stable")[:, :_NEIGHBORS]
        rows = random.integers(len(base), size=count)
        first, second = (
            failures[near[rows, random.integers(near.shape[1], size=count)]] for _ in range(2)
        )
        moved = base[rows] + _MOST_DIFFERENCE * random.random((count, 1)) * (first - second)
        noise = _NOISE * random.random((count, 1)) * random.standard_normal(moved.shape)
        return np.asarray(moved + noise)


def _reflected(vectors: Floats) -> Floats:
    """The vectors, with what is beyond 0 and 1 thrown back."""
    import numpy as np

    return np.asarray(1.0 - np.abs(np.mod(vectors, 2.0) - 1.0))


def one_of_each_neighborhood(vectors: Sequence[Floats]) -> list[Floats]:
    """The first of some vectors (columns,), without those that are near one before them."""
    import numpy as np

    chosen: list[Floats] = []
    rest = np.stack(vectors) if vectors else np.empty((0, 0))
    while len(rest) and len(chosen) < _ELITE:
        chosen.append(rest[0])
        rest = rest[_squares_from(rest, 0) > APART**2 * rest.shape[1]]
    return chosen


def _loss(squares: Floats, unlike: tuple[float, float]) -> Floats:
    """What candidates lose that are as near as this to a failure, or to one that is chosen."""
    import numpy as np

    apart, similar = unlike
    return np.asarray(similar * np.maximum(apart - np.sqrt(squares), 0.0))


def _squares_from(rows: Floats, number: int) -> Floats:
    """(n,) squared distances of rows (n, D) from one of them."""
    import numpy as np

    gaps = rows - rows[number]
    return np.asarray(np.einsum("ij,ij->i", gaps, gaps))


class _Shortlist:
    """Candidates of which some are taken after each other: of little value, and unlike failures and
    unlike each other. `nearest`: of each, the squared distance to the nearest failure."""

    def __init__(
        self, values: Floats, descriptors: Floats, nearest: Floats, unlike: tuple[float, float]
    ) -> None:
        import numpy as np

        self._values = values.copy()
        self._descriptors = descriptors
        self._lengths = np.einsum("ij,ij->i", descriptors, descriptors)
        self._nearest = nearest
        self._unlike = unlike
        self._left = len(values)
        self._alike: dict[int, tuple[Integers, Floats]] = {}
        """by what was taken: the rows that are like it, and their squared distances"""

    def take(self, count: int) -> list[int]:
        """The rows of at most `count` candidates, which are not taken again."""
        nearest, rows = self._nearest.copy(), list[int]()
        score = self._values + _loss(nearest, self._unlike)
        for _ in range(min(count, self._left)):
            best = int(score.argmin())
            rows.append(best)
            self._values[best] = score[best] = float("inf")
            alike, squares = self._alike[best] = self._like(best)
            nearest[alike] = least = squares.clip(max=nearest[alike])
            score[alike] = self._values[alike] + _loss(least, self._unlike)
        self._left -= len(rows)
        return rows

    def keep_apart(self, rows: Sequence[int]) -> None:
        """Those that are taken from now on are to be unlike these, too."""
        for row in rows:
            alike, squares = self._alike[row]
            self._nearest[alike] = squares.clip(max=self._nearest[alike])

    def _like(self, row: int) -> tuple[Integers, Floats]:
        """Which rows are so near one of them that they lose by it, and their squared distances."""
        import numpy as np

        squares = self._descriptors @ (-2.0 * self._descriptors[row])
        squares += self._lengths
        squares += self._lengths[row]
        alike = np.flatnonzero(squares < self._unlike[0] ** 2)
        return alike, np.maximum(squares[alike], 0.0)
