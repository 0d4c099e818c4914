"""Temporal operators with windows that hold no sample, and verdicts that depend on them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ..formula import formulas as f
from .axis import SamplePositions
from .beyond_end import TraceEnd
from .trace import FloatArray


class EmptyOperators(NamedTuple):
    """The operators of a formula with a window between two samples, and those whose windows all
    begin after the end of the trace."""

    between_samples: tuple[f.TemporalOperator, ...] = ()
    beyond_end: tuple[f.TemporalOperator, ...] = ()


def empty_operators(
    formula: f.Formula, positions: FloatArray, wrap: float | None = None
) -> EmptyOperators:
    """Those of samples at `positions` (S,); on a closed road none begins after the end."""
    bounded = [
        part
        for part in formula.walk()
        if isinstance(part, f.TemporalOperator) and part.window is not None
    ]
    if not bounded:
        return EmptyOperators()
    axis = SamplePositions.of(positions, wrap)
    widest = float(np.max(np.diff(axis.positions), initial=0.0))
    if wrap is not None:
        widest = max(widest, wrap - float(axis.positions[-1]))
    between = dict.fromkeys(part for part in bounded if _has_gap(part, axis, widest))
    return EmptyOperators(tuple(between), TraceEnd.of(axis).operators_beyond(formula))


def _has_gap(part: f.TemporalOperator, axis: SamplePositions, widest: float) -> bool:
    window = part.window
    if window is None or window.hi - window.lo >= widest:
        return False
    return bool(axis.between_samples(window, (0, axis.size - 1), past=part.past).any())
