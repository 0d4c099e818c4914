"""The median of many values, from the few that are near it."""

from __future__ import annotations

import numpy as np

from .tones import Layer

_MANY, _SAMPLE = 20_000, 5_000
"""From `_MANY` values on, bounds of the median are estimated by about `_SAMPLE` of them."""
_NEAR = 0.05
"""Quantiles of the sample by so much below and above its median bound that of all values."""


def median(values: Layer) -> float:
    """As `numpy.median` of values (n,), in a quarter of the time for many."""
    if len(values) < _MANY:
        return float(np.median(values))
    low, high = np.quantile(values[:: len(values) // _SAMPLE], (0.5 - _NEAR, 0.5 + _NEAR))
    near = values[(values >= low) & (values <= high)]
    below = int(np.count_nonzero(values < low))
    first, last = (len(values) - 1) // 2 - below, len(values) // 2 - below
    if first < 0 or last >= len(near):
        return float(np.median(values))
    return float(np.partition(near, (first, last))[first : last + 1].mean())
