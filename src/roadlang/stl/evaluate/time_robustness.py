"""How far signals may shift in time before a verdict changes."""

from __future__ import annotations

from typing import Literal, TypeAlias

import numpy as np

from ..formula import formulas as f
from ..formula import terms as t
from ..formula.normal_form import normal_form
from .evaluation import everywhere
from .operations import BOOLEAN
from .trace import FloatArray, Positions, SampledSignals, Signals

Direction: TypeAlias = Literal["right", "left"]


def time_robustness(
    formula: f.Formula,
    positions: Positions,
    signals: Signals,
    *,
    direction: Direction = "right",
) -> FloatArray:
    """Time robustness at every sample, (V, S) or (S,), in the unit of the positions.

    Of a comparison it is how far from a sample on (`right`) or back from it (`left`) the comparison
    stays what it is there, to the last sample that it does and at most to the end of the trace;
    negative where the comparison fails. Of all else it is made by the minima and maxima of
    robustness (Donze and Maler, FORMATS 2010, definition 5). Raises DiagnosticError as
    `robustness` does.
    """
    trace = SampledSignals.of(positions, signals, formula.variables)
    margins: dict[str, FloatArray] = {}

    def timed(part: f.Formula) -> f.Formula:
        if isinstance(part, f.Comparison):
            name = str(part)
            if name not in margins:
                holds = everywhere(part, trace, BOOLEAN) > 0
                margins[name] = _unchanged(holds, trace.positions, direction)
            return f.Comparison(">", t.Variable(name), t.Constant(0.0))
        if isinstance(part, f.Compound):
            return part.with_parts([timed(inner) for inner in part.parts])
        return part

    judged = timed(normal_form(formula))
    values = everywhere(judged, SampledSignals.of(trace.positions, margins, judged.variables))
    values = np.broadcast_to(values, (trace.variants, trace.samples))
    return np.array(values if trace.batched else values[0])


def _unchanged(holds: np.ndarray, positions: FloatArray, direction: Direction) -> FloatArray:
    """(V, S) the distance to the last neighbor that is alike, with the sign of what holds."""
    if direction == "left":
        return _unchanged(holds[:, ::-1], -positions[::-1], "right")[:, ::-1]
    last = np.full(holds.shape[0], positions[-1])
    found = np.empty(holds.shape)
    for sample in range(holds.shape[1] - 1, -1, -1):
        if sample + 1 < holds.shape[1]:
            changes = holds[:, sample] != holds[:, sample + 1]
            last = np.where(changes, positions[sample], last)
        found[:, sample] = last - positions[sample]
    return np.where(holds, found, -found)
