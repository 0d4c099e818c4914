"""The rows of what was computed for many candidates."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..ir.batch import RoadBatch


def rows_of(value: Any, rows: NDArray[np.intp], count: int) -> Any:
    """The rows of what was computed for `count` candidates; what is the same for all stays."""
    if isinstance(value, np.ndarray):
        return value if value.ndim == 0 or value.shape[0] == 1 else value[rows]
    if isinstance(value, RoadBatch):
        return value.take(rows)
    if isinstance(value, tuple):
        return tuple(rows_of(item, rows, count) for item in value)
    if isinstance(value, dict):
        return {key: rows_of(item, rows, count) for key, item in value.items()}
    return value
