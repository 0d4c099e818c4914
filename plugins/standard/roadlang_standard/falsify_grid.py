"""`falsify with grid`: every combination of values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import prod
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Axis, Code, DiagnosticError, Integer, Search, Searcher, diagnose, option

from .unit_cube import MOST_COMBINATIONS

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Grid(Searcher):
    """Every combination of the values of all draws; the search ends after the last."""

    name: ClassVar[str] = "grid"
    is_adaptive: ClassVar[bool] = False
    steps: Integer = option(
        5, minimum=1, maximum=10_000, help="number of values of each continuous draw"
    )

    def start(self, axes: Sequence[Axis], seed: int) -> Search:
        """Raises RL614 beyond ten million combinations."""
        levels = [axis.levels(self.steps) for axis in axes]
        if prod(map(len, levels)) > MOST_COMBINATIONS:
            most = f"{MOST_COMBINATIONS:,}"
            help_ = "use fewer `steps`, make fewer values random, or `falsify with halton`"
            raise DiagnosticError(diagnose(Code.GRID_TOO_LARGE, most=most, help=help_))
        return _GridSearch(levels)


class _GridSearch(Search):
    """The last axis changes fastest."""

    def __init__(self, levels: Sequence[Sequence[float]]) -> None:
        self._levels = levels
        self._size = prod(map(len, levels))
        self._count = 0

    def ask(self, count: int) -> Floats:
        import numpy as np

        rest = np.arange(self._count, min(self._count + count, self._size))
        self._count += len(rest)
        points = np.empty((len(rest), len(self._levels)))
        for column in reversed(range(len(self._levels))):
            levels = np.asarray(self._levels[column])
            points[:, column] = levels[rest % len(levels)]
            rest = rest // len(levels)
        return points
