"""`sample with halton`: a low-discrepancy sequence."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Sampler, Whole, option

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import DrawnValue

    Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Halton(Sampler):
    """A scrambled Halton sequence: covers the space more evenly than random draws."""

    name: ClassVar[str] = "halton"
    attempts: Whole = option(
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
        import numpy as np

        random = np.random.Generator(np.random.Philox(key=seed % 2**64))
        bases = _primes(len(draws))
        points = np.empty((len(indices), len(draws)))
        for column, base in enumerate(bases):
            points[:, column] = _scrambled(np.asarray(indices), base, random)
        return points


def _scrambled(indices: NDArray[np.int64], base: int, random: np.random.Generator) -> Floats:
    """Owen's permuted digits (2017), as many as a double holds."""
    import numpy as np

    digits = int(np.ceil(53 / np.log2(base)))
    inverse, rest, scale = np.zeros(len(indices)), indices.copy(), 1.0 / base
    for _ in range(digits):
        permutation = random.permutation(base)
        inverse += permutation[rest % base] * scale
        rest, scale = rest // base, scale / base
    return np.minimum(inverse, 1.0 - 2.0**-53)


def _primes(count: int) -> list[int]:
    found: list[int] = []
    number = 2
    while len(found) < count:
        if all(number % prime for prime in found if prime * prime <= number):
            found.append(number)
        number += 1
    return found
