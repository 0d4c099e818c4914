"""`normal(mean, sd)`: a normal distribution, optionally truncated."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Between, Distribution, Like, option

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Normal(Distribution):
    """A normal distribution, truncated to `within` if that is given."""

    name: ClassVar[str] = "normal"
    mean: Like = option(help="mean")
    sd: Like = option(minimum=0, help="standard deviation")
    within: Between = option(None, help="`[low, high]`: truncation bounds")

    def quantile(self, uniform: Floats) -> Floats:
        """By inversion between the probabilities of the ends."""
        import numpy as np
        from scipy.special import ndtr, ndtri

        sd = np.maximum(self.sd, 1e-300)
        if self.within is None:
            return self.mean + sd * ndtri(np.clip(uniform, 1e-16, 1.0 - 1e-16))
        low, high = self.within
        # The upper tail is inverted as a lower one, where doubles near zero are finer.
        sign = np.where(np.asarray(low) + np.asarray(high) > 2.0 * np.asarray(self.mean), -1.0, 1.0)
        near = np.where(sign > 0, low, high)
        far = np.where(sign > 0, high, low)
        least = ndtr(sign * (near - self.mean) / sd)
        most = ndtr(sign * (far - self.mean) / sd)
        share = np.where(sign > 0, uniform, 1.0 - uniform)
        value = self.mean + sign * sd * ndtri(np.maximum(least + (most - least) * share, 1e-300))
        return np.asarray(np.clip(value, low, high))

    def support(self) -> tuple[float, float] | None:
        return None if self.within is None else (self.within[0], self.within[1])
