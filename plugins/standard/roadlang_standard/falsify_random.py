"""`falsify with random`: independent draws."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Axis, Search, Searcher

if TYPE_CHECKING:
    import numpy as np

    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Random(Searcher):
    """Independent random draws: the share of failures among them estimates the failure rate."""

    name: ClassVar[str] = "random"
    is_adaptive: ClassVar[bool] = False
    is_random: ClassVar[bool] = True

    def start(self, axes: Sequence[Axis], seed: int) -> Search:
        import numpy as np

        return _RandomSearch(len(axes), np.random.Generator(np.random.Philox(key=seed % 2**64)))


class _RandomSearch(Search):
    def __init__(self, dimensions: int, random: np.random.Generator) -> None:
        self._dimensions = dimensions
        self._random = random

    def ask(self, count: int) -> Floats:
        return self._random.random((count, self._dimensions))
