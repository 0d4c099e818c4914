"""`a..b`, or `uniform(a, b)`: a uniform distribution."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Distribution, Like, option

from .unit_cube import BELOW_ONE

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Uniform(Distribution):
    """A uniformly distributed real number; `a..b` is the same."""

    name: ClassVar[str] = "uniform"
    is_default: ClassVar[bool] = True
    low: Like = option(help="lower bound")
    high: Like = option(help="upper bound")

    def quantile(self, uniform: Floats) -> Floats:
        return self.low + (self.high - self.low) * uniform

    def support(self) -> tuple[float, float] | None:
        return self.low, self.high

    def levels(self, steps: int) -> list[float]:
        """Both ends and even steps between them."""
        return [0.5] if steps == 1 else [step / (steps - 1) for step in range(steps)]

    def simplest(self) -> float:
        """0, or the end of the range that is nearer to it."""
        if not self.low < self.high:
            return 0.5
        at = -self.low / (self.high - self.low)
        return float(min(max(at, 0.0), BELOW_ONE))
