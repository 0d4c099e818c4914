"""Medians and quantiles of few values without numpy's preparations; the median of many from the
few near it."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

_FEW = 4_000
"""Fewer values are sorted."""
_MANY, _SAMPLE = 20_000, 5_000
"""From `_MANY` values on, bounds of the median are estimated by about `_SAMPLE` of them."""
_NEAR = 0.05
"""Quantiles of the sample by so much below and above its median bound that of all values."""


def median(values: NDArray[Any]) -> float:
    """As `numpy.median` of values (n,), in a tenth of the time for few and a quarter for many."""
    if 0 < len(values) < _FEW:
        return _of_few(values)
    if len(values) < _MANY:
        return float(np.median(values))
    low, high = np.quantile(values[:: len(values) // _SAMPLE], (0.5 - _NEAR, 0.5 + _NEAR))
    near = values[(values >= low) & (values <= high)]
    below = int(np.count_nonzero(values < low))
    first, last = (len(values) - 1) // 2 - below, len(values) // 2 - below
    if first < 0 or last >= len(near):
        return float(np.median(values))
    return float(np.partition(near, (first, last))[first : last + 1].mean())


def quantile(values: NDArray[np.floating[Any]], share: float) -> float:
    """As `numpy.quantile` of values (n,), in a tenth of the time for few."""
    if not 0 < len(values) < _FEW:
        return float(np.quantile(values, share))
    ascending = values.copy()
    ascending.sort()  # puts what is not a number last
    if ascending[-1] != ascending[-1]:
        return float("nan")
    last = len(ascending) - 1
    place = last * share
    low = int(place)
    below, above = ascending[low], ascending[min(low + 1, last)]
    step, part = above - below, place - low
    # From the nearer one, and in the type of the values: so numpy rounds.
    return float(below + step * part if part < 0.5 else above - step * (1 - part))


def _of_few(values: NDArray[Any]) -> float:
    ascending = values.copy()
    ascending.sort()  # puts what is not a number last
    if ascending[-1] != ascending[-1]:
        return float("nan")
    middle = len(ascending) // 2
    if len(ascending) % 2:
        return float(ascending[middle])
    return float((ascending[middle - 1] + ascending[middle]) / 2)
