"""How far signals may shift in time before a verdict changes."""

from __future__ import annotations

from typing import Literal, TypeAlias, get_args

import numpy as np

from ..errors import check_word
from ..formula import formulas as f
from ..formula import terms as t
from ..formula.normal_form import normal_form
from ..formula.variables import variables_of
from .evaluation import at_start, everywhere
from .graph_operations import BOOLEAN
from .trace import FloatArray, Positions, SampledSignals, Signals
from .windows import BoolArray

Direction: TypeAlias = Literal["right", "left"]


def time_robustness(
    formula: f.Formula,
    positions: Positions,
    signals: Signals,
    *,
    direction: Direction = "right",
    wrap: float | None = None,
) -> FloatArray:
    """Time robustness at every sample, (V, S) or (S,), in the unit of the positions.

    Of a comparison it is how far from a sample on (`right`) or back from it (`left`) the comparison
    stays what it is there, to the last sample that it does and at most to the end of the trace, or
    once around a closed road; negative where the comparison fails. Of all else it is made by the
    minima and maxima of robustness (Donze and Maler, FORMATS 2010, definition 5). Raises
    DiagnosticError as `robustness` does.
    """
    trace = SampledSignals.of(positions, signals, variables_of(formula), wrap)
    values = everywhere(*_timed(formula, trace, direction))
    values = np.broadcast_to(values, (trace.variants, trace.samples))
    return np.array(values if trace.batched else values[0])


def time_rho(
    formula: f.Formula,
    positions: Positions,
    signals: Signals,
    *,
    direction: Direction = "right",
    wrap: float | None = None,
) -> FloatArray:
    """Time robustness at the first sample, (V,) or a scalar."""
    trace = SampledSignals.of(positions, signals, variables_of(formula), wrap)
    values = np.broadcast_to(at_start(*_timed(formula, trace, direction)), (trace.variants,))
    return np.array(values if trace.batched else values[0])


def _timed(
    formula: f.Formula, trace: SampledSignals, direction: Direction
) -> tuple[f.Formula, SampledSignals]:
    """The formula over signals that are the time robustness of its comparisons."""
    check_word("direction", direction, get_args(Direction))
    margins: dict[str, FloatArray] = {}

    def timed(part: f.Formula) -> f.Formula:
        if isinstance(part, f.Comparison):
            name = str(part)
            if name not in margins:
                holds = everywhere(part, trace, BOOLEAN) > 0
                margins[name] = _unchanged(holds, trace.positions, direction, trace.wrap)
            return f.Comparison(">", t.Variable(name), t.Constant(0.0))
        if isinstance(part, f.Compound):
            return part.with_parts([timed(inner) for inner in part.parts])
        return part

    judged = timed(normal_form(formula))
    return judged, SampledSignals.of(trace.positions, margins, judged.variables, trace.wrap)


def _unchanged(
    holds: BoolArray, positions: FloatArray, direction: Direction, wrap: float | None
) -> FloatArray:
    """(V, S) the distance to the last neighbor that is alike, with the sign of what holds."""
    if direction == "left":
        return _unchanged(holds[:, ::-1], -positions[::-1], "right", wrap)[:, ::-1]
    samples = holds.shape[1]
    if wrap is not None:
        holds, positions = np.tile(holds, 2), np.concatenate([positions, positions + wrap])
    last = np.full(holds.shape[0], positions[-1])
    found = np.empty(holds.shape)
    for sample in range(holds.shape[1] - 1, -1, -1):
        if sample + 1 < holds.shape[1]:
            changes = holds[:, sample] != holds[:, sample + 1]
            last = np.where(changes, positions[sample], last)
        found[:, sample] = last - positions[sample]
    found, holds = found[:, :samples], holds[:, :samples]
    if wrap is not None:
        found = np.minimum(found, wrap)
    return np.where(holds, found, -found)
