"""`sample with halton`: a low-discrepancy sequence."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Integer, Sampler, option

from .halton_sequence import halton_points

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import DrawnValue
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class HaltonSampler(Sampler):
    """A scrambled Halton sequence: covers the space more evenly than random draws."""

    name: ClassVar[str] = "halton"
    also_called: ClassVar[tuple[str, ...]] = ("sobol", "latin_hypercube", "lhs")
    attempts: Integer = option(
        None,
        minimum=1,
        maximum=100_000_000,
        help="maximum number of candidates; by default about five seconds of work",
    )

    def limit(self) -> int | None:
        """The option `attempts`."""
        return self.attempts

    def points(self, indices: NDArray[np.int64], draws: Sequence[DrawnValue], seed: int) -> Floats:
        """Radical inverses in prime bases, digits permuted at random, one base for each draw."""
        return halton_points(indices, len(draws), seed)
