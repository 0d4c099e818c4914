"""What faults do to a control: it comes late, is wrong, or does not change any more."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    from roadlang.api import ActuationBatch


def first_state(count: int) -> NDArray[np.object_]:
    """Of each agent, what was wanted at the last steps, and the value at which it is stuck."""
    state = np.empty((count, 2), dtype=object)
    for row in range(count):
        state[row] = [], math.nan
    return state


def disturbed(
    wanted: NDArray[np.float64],
    at: ActuationBatch,
    state: Any,
    *,
    delay: ArrayLike,
    gain: ArrayLike,
    bias: ArrayLike,
    noise: ArrayLike,
    stuck: bool,
) -> NDArray[np.float64]:
    """(N,) what an actuator does instead of what is `wanted`, where the fault is active.

    The control of `delay` seconds ago, or the first one, times `gain`, plus `bias` and normal
    errors of standard deviation `noise`; or, where it is `stuck`, for as long as the fault is
    active what it did when that began.
    """
    count = len(wanted)
    lags = np.rint(np.broadcast_to(np.asarray(delay, dtype=np.float64), count) / at.step)
    late = np.array([_late(state[row, 0], float(wanted[row]), int(lags[row]))
                     for row in range(count)])  # fmt: skip
    factor, error, spread = (np.asarray(value, dtype=np.float64) for value in (gain, bias, noise))
    found = late * factor + error + spread * at.random.normal(1)[:, 0]
    if not stuck:
        return np.where(at.active, found, wanted)
    held = np.array(state[:, 1], dtype=np.float64)
    held = np.where(at.active, np.where(np.isnan(held), found, held), math.nan)
    state[:, 1] = held
    return np.where(at.active, held, wanted)


def _late(past: list[float], wanted: float, lag: int) -> float:
    """What was wanted `lag` steps ago."""
    past.append(wanted)
    del past[: max(0, len(past) - lag - 1)]
    return past[0]
