"""Which of many pairs of agents are so close that they may touch; compiled where numba is loaded,
with the same formula and to the same bits."""

from __future__ import annotations

import sys
from functools import cache
from typing import Any

import numpy as np

from ...geometry.arrays import Floats, Integers
from ..vehicles import compiled


def is_close(off_x: Any, off_y: Any, reach: Any) -> Any:
    """Whether two are no farther apart than `reach`, meters."""
    return off_x * off_x + off_y * off_y <= reach * reach


def close_pairs(pairs: tuple[Integers, Integers], x: Floats, y: Floats, around: Floats) -> Integers:
    """The numbers of the pairs (P,) whose circles meet: of agents at places (N,) with radii
    `around` (N,)."""
    first, second = pairs
    if compiled.is_loaded():
        close = np.empty(len(first), dtype=bool)
        _compiled_loop()(first, second, x, y, around, close)
        return close.nonzero()[0]
    off_x, off_y = x.take(first) - x.take(second), y.take(first) - y.take(second)
    close = is_close(off_x, off_y, around.take(first) + around.take(second))
    return np.asarray(close.nonzero()[0])


def loop_over_close(
    first: Any, second: Any, x: Any, y: Any, around: Any, close: Any
) -> None:  # fmt: skip
    """Fill `close` (P,). numba compiles it; Python never runs it."""
    for pair in range(first.shape[0]):
        i, j = first[pair], second[pair]
        close[pair] = is_close(x[i] - x[j], y[i] - y[j], around[i] + around[j])


@cache
def _compiled_loop() -> Any:
    compiled.register((is_close,), (loop_over_close,))
    return compiled.compile_loop(loop_over_close, sys.modules[__name__])
