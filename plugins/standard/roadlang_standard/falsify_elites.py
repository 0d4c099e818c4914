"""`falsify with elites`: the worst drive of each kind of behavior, for many kinds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Axis, Integer, Number, Search, Searcher, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Elites(Searcher):
    """MAP-Elites (Mouret and Clune 2015): the least robust drive of each road and behavior that
    differs from all others, and children of these. For a survey: `cma` finds more failures."""

    name: ClassVar[str] = "elites"
    also_called: ClassVar[tuple[str, ...]] = ("map_elites", "quality_diversity")
    initial: Integer = option(
        200, minimum=2, help="candidates of a Halton sequence before the first children"
    )
    step: Number = option(
        0.05, above=0, maximum=1, help="standard deviation of children, as a fraction of each range"
    )
    line: Number = option(
        0.2,
        minimum=0,
        maximum=2,
        help="standard deviation of children along the line to a second parent, as a fraction of "
        "that line",
    )

    def start(self, axes: Sequence[Axis], seed: int) -> Search:
        return ElitesSearch(axes, seed, self)


class ElitesSearch(Search):
    """The niches are not cells of a grid but drives whose descriptors are further apart than 1
    (Cully and Demiris 2018: an unstructured archive); children vary in all directions, and along
    the line to another elite (Vassiliades and Mouret 2018). Until something can be driven, the
    candidates that violate requirements least are the parents."""

    def __init__(self, axes: Sequence[Axis], seed: int, options: Elites) -> None:
        import numpy as np

        from .cube_encoding import CubeEncoding

        self._random = np.random.Generator(np.random.Philox(key=seed % 2**64))
        self._encoding = CubeEncoding(axes)
        self._options = options
        self._seed = seed
        self._count = 0
        self._vectors = np.empty((0, self._encoding.columns))
        self._archive = Archive()

    def ask(self, count: int) -> Floats:
        import numpy as np

        from .halton_sequence import halton_points

        indices = np.arange(self._count, self._count + count)
        self._count += count
        columns = self._encoding.columns
        self._vectors = halton_points(indices, columns, self._seed)
        late = indices >= self._options.initial
        if self._archive.vectors:
            self._vectors[late] = self._children(int(late.sum()))
        return self._encoding.points(self._vectors)

    def tell(self, points: Floats, values: Floats, descriptors: Floats) -> None:
        self._archive.add(self._vectors, values, descriptors)

    def _children(self, count: int) -> Floats:
        import numpy as np

        random, parents = self._random, np.stack(self._archive.vectors)
        first, second = (parents[random.integers(len(parents), size=count)] for _ in range(2))
        along = self._options.line * random.standard_normal((count, 1))
        child = first + along * (second - first)
        child = child + self._options.step * random.standard_normal(child.shape)
        return np.asarray(1.0 - np.abs(np.mod(child, 2.0) - 1.0))


class Archive:
    """The best vector of each niche. What was not driven shares one niche, which the first drive
    ends."""

    def __init__(self) -> None:
        self.vectors: list[Floats] = []
        self.values: list[float] = []
        self._descriptors: list[Floats] = []

    def add(self, vectors: Floats, values: Floats, descriptors: Floats) -> None:
        """Vectors (n, columns) with their values (n,) and descriptors (n, D)."""
        import numpy as np

        for vector, value, descriptor in zip(vectors, values.tolist(), descriptors, strict=True):
            is_driven = value < 1.0 and bool(np.isfinite(descriptor).all())
            if not is_driven and self._descriptors:
                continue
            if is_driven and not self._descriptors:
                self.vectors, self.values = [], []
            niche = self._niche(descriptor) if is_driven else (0 if self.values else -1)
            if niche < 0:
                self.vectors.append(vector)
                self.values.append(value)
                if is_driven:
                    self._descriptors.append(descriptor)
            elif value < self.values[niche]:
                self.vectors[niche], self.values[niche] = vector, value

    def _niche(self, descriptor: Floats) -> int:
        """The nearest niche, if it is not too far; -1 for a new one."""
        import numpy as np

        if not self._descriptors:
            return -1
        gaps = np.stack(self._descriptors) - descriptor
        squares = (gaps * gaps).sum(axis=1)
        nearest = int(squares.argmin())
        return nearest if squares[nearest] <= 1.0 else -1
