"""Temporal operators whose windows fall between two samples and so have nothing to look at."""

from __future__ import annotations

import numpy as np

from ..formula import formulas as f
from .axis import SamplePositions
from .trace import SampledSignals


def operators_between_samples(
    formula: f.Formula, trace: SampledSignals
) -> tuple[f.TemporalOperator, ...]:
    """The operators of `formula` that have a window inside the trace without any sample."""
    axis = SamplePositions.of(trace.positions, trace.wrap)
    widest = float(np.max(np.diff(axis.positions), initial=0.0))
    if trace.wrap is not None:
        widest = max(widest, trace.wrap - float(axis.positions[-1]))
    found = dict.fromkeys(
        part
        for part in formula.walk()
        if isinstance(part, f.TemporalOperator)
        and part.window is not None
        and part.window.hi - part.window.lo < widest
        and axis.between_samples(part.window, (0, trace.samples - 1), past=part.past).any()
    )
    return tuple(found)
