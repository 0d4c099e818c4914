"""The one definition of "satisfied": the sign of robustness, and Boolean semantics at exactly 0."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .trace import FloatArray

Rows = NDArray[np.intp]
Truth = Callable[[Rows], ArrayLike]


def is_satisfied(rho: FloatArray, truth: Truth) -> NDArray[np.bool_]:
    """(V,) whether something of robustness `rho` (V,) is satisfied.

    Above 0 it is, below 0 it is not. At exactly 0 (-0 included) robustness cannot tell `x <= 5`
    from `x < 5`: `truth(rows)` then gives what Boolean evaluation says of the variants `rows`.
    """
    satisfied = np.asarray(rho > 0.0)
    zero = np.flatnonzero(rho == 0.0)
    if zero.size:
        satisfied[zero] = truth(zero)
    return satisfied


def zero_satisfies(rows: Rows) -> NDArray[np.bool_]:
    """The truth of what has robustness but no formula, as a monitor of a plugin: 0 satisfies it."""
    return np.ones(rows.shape, dtype=bool)
