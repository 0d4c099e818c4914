"""Robustness by other measures than the margins of comparisons alone: in time, and on average."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal, TypeAlias

from ..formula import formulas as f
from .average_robustness import average_robustness
from .evaluation import robustness
from .time_robustness import time_robustness
from .trace import FloatArray, Positions, Signals

Measure: TypeAlias = Literal["space", "time", "time-left", "average"]
"""What robustness measures: by how much signals may change, by how much they may be shifted to
later or earlier times, or their margins averaged over windows."""


def measured_robustness(
    formula: f.Formula, positions: Positions, signals: Signals, measure: Measure
) -> FloatArray:
    """The robustness at every sample by a measure, (V, S) or (S,)."""
    return _MEASURES[measure](formula, positions, signals)


def _time_left(formula: f.Formula, positions: Positions, signals: Signals) -> FloatArray:
    return time_robustness(formula, positions, signals, direction="left")


_MEASURES: dict[str, Callable[[f.Formula, Positions, Signals], FloatArray]] = {
    "space": robustness,
    "time": time_robustness,
    "time-left": _time_left,
    "average": average_robustness,
}
