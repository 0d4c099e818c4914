"""Errors of sensors that wander: random walks (Brownian motion), sampled at measurements."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from roadlang.api import SensedBatch
    from roadlang.geometry import Floats


def walked(sensed: SensedBatch, deviation: Floats | float, normal: Floats) -> Floats:
    """(N, K) the steps of walks since the measurement before, whose standard deviation grows by
    `deviation` (N,) in the square root of a second. `normal`: (N, K) standard normal numbers."""
    scale = np.asarray(deviation) * np.sqrt(sensed.interval)
    return np.asarray(scale[..., None] * normal)
