"""`integer(a, b)`: a uniformly distributed integer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Distribution, Integer, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


_MOST_CELLS = 1_000


@dataclass(frozen=True)
class UniformInteger(Distribution):
    """A uniformly distributed integer from `low` to `high`, both included."""

    name: ClassVar[str] = "integer"
    low: Integer = option(help="smallest value")
    high: Integer = option(help="largest value")

    def quantile(self, uniform: Floats) -> Floats:
        import numpy as np

        count = np.asarray(self.high) - self.low + 1
        return np.asarray(self.low + np.minimum(np.floor(uniform * count), count - 1))

    def support(self) -> tuple[float, float] | None:
        return self.low, self.high

    def levels(self, steps: int) -> list[float]:
        """Each number once, whatever `steps` says."""
        count = self.high - self.low + 1
        return [(number + 0.5) / count for number in range(count)]

    def cells(self) -> list[float] | None:
        """Of more than a thousand numbers, none is searched for individually."""
        count = self.high - self.low + 1
        if count > _MOST_CELLS:
            return None
        return [(number + 1) / count for number in range(count)]

    def simplest(self) -> float:
        """The number nearest to 0."""
        nearest = min(max(0, self.low), self.high)
        return (nearest - self.low + 0.5) / (self.high - self.low + 1)
