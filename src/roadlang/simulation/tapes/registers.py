"""Rows of memory for columns of agents, so that a processor reads them at its fastest."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...geometry.arrays import Floats

_LINE = 64
"""Bytes that a processor fetches at once: arithmetic of rows that begin within one is slower."""


def aligned(rows: int, count: int) -> Floats:
    """(rows, count) new numbers; each row begins where memory is fetched at once."""
    each = _LINE // 8
    wide = -(-count // each) * each + each  # not all at the same place of a page
    memory = np.empty(rows * wide + each)
    begin = (-memory.ctypes.data % _LINE) // 8
    found: Floats = memory[begin : begin + rows * wide].reshape(rows, wide)[:, :count]
    return found


def shared(column: Floats) -> Any:
    """() the number that all of a column (N,) are, to the last bit: arithmetic with it is faster.
    None where they differ."""
    whole = np.ascontiguousarray(column, dtype=np.float64).view(np.int64)
    is_one = len(whole) > 0 and not np.count_nonzero(whole != whole[0])
    return np.array(column[0], dtype=np.float64) if is_one else None
