"""Round lengths, for scale bars and marks along roads."""

from __future__ import annotations

import math


def round_length(meters: float) -> float:
    """The greatest of 1, 2 or 5 times a power of ten that is not longer."""
    power = 10.0 ** math.floor(math.log10(meters))
    return next(step * power for step in (5, 2, 1) if step * power <= meters * (1 + 1e-9))
