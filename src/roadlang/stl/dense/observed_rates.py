"""How fast signals change between their samples, for the bound of the sampling error."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ...diagnostics import Code, DiagnosticError
from ..evaluate.trace import Positions
from ..formula import formulas as f
from ..formula.evaluation_options import Semantics
from ..formula.variables import variables_of
from .evaluation import sampling_error
from .grids import GridSignals, GridsOrSignals


def observed_rates(
    formula: f.Formula, positions: Positions, signals: GridsOrSignals
) -> Mapping[str, float]:
    """The greatest change per unit of the positions from one sample to the next, of each signal."""
    grids = GridSignals.of(positions, signals, variables_of(formula))
    rates = {}
    for name, trace in grids.traces.items():
        values = np.broadcast_to(
            trace.rows(name, 0, trace.variants), (trace.variants, trace.samples)
        )
        with np.errstate(invalid="ignore", over="ignore"):
            steps = np.abs(np.diff(values, axis=1)) / np.diff(trace.positions)
        rates[name] = float(np.max(steps, initial=0.0))
    return rates


def observed_sampling_error(
    formula: f.Formula, positions: Positions, signals: GridsOrSignals, semantics: Semantics
) -> float | None:
    """`sampling_error`, if no signal changes faster than it does from sample to sample; None where
    that says nothing: products, and signals without bounds."""
    rates = observed_rates(formula, positions, signals)
    if not np.isfinite(list(rates.values())).all():
        return None
    try:
        return sampling_error(formula, positions, signals, rates, semantics)
    except DiagnosticError as error:
        if {found.code for found in error.diagnostics} == {Code.UNKNOWN_BETWEEN_SAMPLES}:
            return None
        raise
