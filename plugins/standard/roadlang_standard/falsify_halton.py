"""`falsify with halton`: a low-discrepancy sequence."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Axis, Search, Searcher

from .halton_sequence import halton_points

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Halton(Searcher):
    """A scrambled Halton sequence: covers the space more evenly than random draws."""

    name: ClassVar[str] = "halton"
    also_called: ClassVar[tuple[str, ...]] = ("sobol", "latin_hypercube", "lhs")
    is_adaptive: ClassVar[bool] = False

    def start(self, axes: Sequence[Axis], seed: int) -> Search:
        return _HaltonSearch(len(axes), seed)


class _HaltonSearch(Search):
    def __init__(self, dimensions: int, seed: int) -> None:
        self._dimensions = dimensions
        self._seed = seed
        self._count = 0

    def ask(self, count: int) -> Floats:
        import numpy as np

        indices = np.arange(self._count, self._count + count)
        self._count += count
        return halton_points(indices, self._dimensions, self._seed)
