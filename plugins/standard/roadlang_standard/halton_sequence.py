"""The scrambled Halton sequence, for samplers and searchers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .unit_cube import BELOW_ONE

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.geometry import Floats


def halton_points(indices: NDArray[np.int64], dimensions: int, seed: int) -> Floats:
    """The points (n, dimensions) at `indices` (n,) of the sequence, each by its index alone."""
    import numpy as np

    random = np.random.Generator(np.random.Philox(key=seed % 2**64))
    points = np.empty((len(indices), dimensions))
    for column, base in enumerate(_primes(dimensions)):
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
    return np.minimum(inverse, BELOW_ONE)


def _primes(count: int) -> list[int]:
    found: list[int] = []
    number = 2
    while len(found) < count:
        if all(number % prime for prime in found if prime * prime <= number):
            found.append(number)
        number += 1
    return found
