"""Groups of equal keys in a sorted column: what `numpy.unique` gives, without sorting again."""

from __future__ import annotations

import numpy as np

from ...geometry.arrays import Integers


def sorted_groups(keys: Integers) -> tuple[Integers, Integers, Integers]:
    """Of ascending keys (n,): the G different ones, where each begins (G,), and the number of the
    group (n,) of each key."""
    first = np.empty(len(keys), dtype=bool)
    first[:1] = True
    np.not_equal(keys[1:], keys[:-1], out=first[1:])
    start = first.nonzero()[0]
    return keys[start], start, first.cumsum() - 1
