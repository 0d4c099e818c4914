"""What metrics of drives are given, checked where it is given: not deep in what it is for.

All raise `TypeError` for what is of another type and `ValueError` for what makes no sense, with the
name of the argument.
"""

from __future__ import annotations

import math
from numbers import Real
from typing import TYPE_CHECKING, Any

import numpy as np

from roadlang.api import AgentTrace

if TYPE_CHECKING:
    from roadlang.geometry import Floats


def agent(name: str, value: Any) -> AgentTrace:
    """An agent of a trace."""
    if not isinstance(value, AgentTrace):
        expected = 'an agent of a trace, such as `drive.trace.agents["ego"]`'
        raise TypeError(f"`{name}` must be {expected}, not {_shown(value)}")
    return value


def pair(first: Any, second: Any) -> tuple[AgentTrace, AgentTrace]:
    """Two agents of one drive."""
    one, other = agent("first", first), agent("second", second)
    if not np.array_equal(one.time, other.time):
        counts = f"{len(one.time)} and {len(other.time)} times"
        raise ValueError(f"`first` and `second` must be agents of one drive, not of {counts}")
    return one, other


def samples(values: Any, time: Any) -> tuple[Floats, Floats]:
    """Arrays (T,) of numbers and of times in order. Values may be infinite or NaN."""
    some, times = _column("values", values), _column("time", time)
    if len(some) != len(times):
        raise ValueError(
            f"`values` and `time` must be equally long, not {len(some)} and {len(times)} samples"
        )
    if not (np.isfinite(times).all() and (np.diff(times) >= 0.0).all()):
        raise ValueError("`time` must be finite numbers in ascending order")
    return some, times


def threshold(value: Any) -> float:
    """A number."""
    if not isinstance(value, Real) or isinstance(value, bool):
        raise TypeError(f"`threshold` must be a number in SI units, not {_shown(value)}")
    if math.isnan(value):
        raise ValueError("`threshold` must be a number, not NaN")
    return float(value)


def _column(name: str, value: Any) -> Floats:
    try:
        found = np.asarray(value)
    except ValueError:  # rows of different lengths
        found = np.asarray(None)
    if found.dtype.kind not in "fiu" and found.size:
        raise TypeError(f"`{name}` must be an array of numbers, not {_shown(value)}")
    if found.ndim != 1:
        raise ValueError(f"`{name}` must be of the shape (T,), not {found.shape}")
    return found.astype(float)


def _shown(value: Any) -> str:
    written = repr(value)
    return written if len(written) <= 40 else f"something of type `{type(value).__name__}`"
