"""Rows of moved curves by loops that numba compiles: the same formulas, the same bits."""

from __future__ import annotations

import sys
from functools import cache
from typing import Any

import numpy as np

from ..arrays import Booleans, Floats, Integers, read_only
from ..numbers import compiling
from . import row_loops

LOADING = 1_000_000
"""Numbers of rows for which numpy takes about as long as it takes to load the compiled loops."""
_worked = [0]
"""Numbers of this process: they decide which of two ways is used, which are the same to the last
bit."""
_NO_VELOCITY = np.empty((2, 0, 0))

Limits = tuple[float, float, bool]
"""What curves that are certain not to fold keep: the least advance, the greatest bend, both as of
`smooth_moves.limits`; and whether they are closed."""


def pays(numbers: int) -> bool:
    """Whether to use the compiled loops for this many more numbers. numba is not loaded for rows
    alone: that takes longer than most processes spend on them."""
    if "numba" not in sys.modules:
        return False
    _worked[0] += numbers
    return _worked[0] > LOADING


def pushed(
    state: Floats,
    distance: Floats,
    rows: Integers,
    stencil: tuple[float, float, Any],
    limits: Limits,
    smooth: Booleans,
    velocity: Floats | None = None,
) -> None:
    """What `row_loops.pushed` says."""
    wanted = _NO_VELOCITY if velocity is None else velocity
    distance = read_only(np.ascontiguousarray(distance))
    loop()(state, distance, read_only(rows), stencil, limits, smooth, wanted)


@cache
def loop() -> Any:
    """The compiled loop over rows."""
    register_jitable = compiling.loaded().extending.register_jitable
    for part in (
        row_loops.pushed_points, row_loops.pushed_frame, row_loops.differenced,
        row_loops.is_smooth, row_loops.pushed,
    ):  # fmt: skip
        register_jitable(**compiling.OPTIONS)(part)
    return compiling.compiled(row_loops.pushed, compiling.digest_of(row_loops))
