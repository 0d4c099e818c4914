"""What signals that are known between samples say about a formula, whatever comes next."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..evaluate.beyond_end import TraceEnd
from ..evaluate.satisfaction import is_satisfied
from ..evaluate.trace import FloatArray, Positions
from ..formula import formulas as f
from ..formula.evaluation_options import Semantics
from ..formula.normal_form import normal_form
from ..formula.strengthening import strengthened
from .bounds import DenseBounds
from .evaluation import DenseEvaluation, refuse_laps
from .grids import GridSignals, GridsOrSignals
from .piecewise import PiecewiseLinear

Ends: TypeAlias = Callable[..., tuple[FloatArray, FloatArray]]


def dense_truth(
    formula: f.Formula,
    positions: Positions,
    signals: GridsOrSignals,
    semantics: Semantics,
    wrap: float | None = None,
) -> NDArray[np.bool_]:
    """Whether the formula is satisfied at each of `positions`, (V, S) or (S,)."""
    grids, truths = _truths(formula, positions, signals, semantics, wrap)
    stations = grids.checked(positions)
    found = [truth.limits(stations)[1] > 0 for truth in truths]
    return np.array(found) if grids.batched else found[0]


def dense_satisfied(
    formula: f.Formula,
    positions: Positions,
    signals: GridsOrSignals,
    semantics: Semantics,
    wrap: float | None = None,
) -> NDArray[np.bool_]:
    """Whether the formula is satisfied at the start, (V,) or a scalar."""
    grids, truths = _truths(formula, positions, signals, semantics, wrap)
    found = np.array([truth.at[0] > 0 for truth in truths])
    return found if grids.batched else found[0]


def _truths(
    formula: f.Formula,
    positions: Positions,
    signals: GridsOrSignals,
    semantics: Semantics,
    wrap: float | None,
) -> tuple[GridSignals, Iterator[PiecewiseLinear]]:
    """The signals, and for each variant 1 where it satisfies the formula and -1 where not."""
    refuse_laps(wrap, semantics)
    grids, plain = GridSignals.of(positions, signals, formula.variables), normal_form(formula)
    variants = range(grids.variants)
    return grids, (
        DenseEvaluation(grids, semantics, v, boolean=True).formula(plain) for v in variants
    )


def dense_range(
    formula: f.Formula,
    positions: Positions,
    signals: GridsOrSignals,
    semantics: Semantics,
    wrap: float | None = None,
) -> tuple[FloatArray, FloatArray]:
    """The least and the greatest robustness at the start over all continuations, (V,) or scalars.

    Raises DiagnosticError RL311 as `rho` does.
    """
    refuse_laps(wrap, semantics)
    grids = GridSignals.of(positions, signals, formula.variables)
    lo, hi = _ends(formula, grids, semantics, boolean=False)
    return (lo, hi) if grids.batched else (lo[0], hi[0])


def dense_verdict(
    formula: f.Formula,
    positions: Positions,
    signals: GridsOrSignals,
    semantics: Semantics,
    wrap: float | None = None,
    finished: bool = False,
) -> NDArray[np.str_]:
    """Satisfied, violated or unknown: (V,) words, or one; at exactly 0 Boolean evaluation decides.

    No window falls between two samples. If the trace is `finished`, none is unknown, and one is
    vacuous that depends on operators whose windows all begin after the end.
    """
    refuse_laps(wrap, semantics)
    grids = GridSignals.of(positions, signals, formula.variables)
    found = _verdicts(formula, grids, semantics, _ends)
    if finished:
        now = _verdicts(formula, grids, semantics, _values)
        other = operators_end(grids).reversed(formula)
        differs = now != _verdicts(other, grids, semantics, _values)
        found = np.where(found == "unknown", np.where(differs, "vacuous", now), found)
    return found if grids.batched else found[0]


def operators_end(grids: GridSignals) -> TraceEnd:
    """The end of the time for which all signals are known."""
    return TraceEnd(float(grids.span[-1]), grids.tolerance)


def _verdicts(
    formula: f.Formula, grids: GridSignals, semantics: Semantics, ends: Ends
) -> NDArray[np.str_]:
    """(V,) words by the least and the greatest robustness."""
    lo, hi = ends(formula, grids, semantics, boolean=False)

    @cache
    def boolean() -> tuple[FloatArray, FloatArray]:
        return ends(formula, grids, semantics, boolean=True)

    always = is_satisfied(_settled(lo, grids), lambda rows: boolean()[0][rows] > 0)
    ever = is_satisfied(_settled(hi, grids), lambda rows: boolean()[1][rows] > 0)
    return np.where(always, "satisfied", np.where(ever, "unknown", "violated"))


def _settled(rho: FloatArray, grids: GridSignals) -> FloatArray:
    """Robustness that differs from 0 by rounding alone is 0."""
    return np.where(np.abs(rho) <= grids.rounding(), 0.0, rho)


def _values(
    formula: f.Formula, grids: GridSignals, semantics: Semantics, *, boolean: bool
) -> tuple[FloatArray, FloatArray]:
    """The robustness (V,), as both ends of a range."""
    plain = normal_form(formula)
    variants = range(grids.variants)
    evaluations = (DenseEvaluation(grids, semantics, v, boolean=boolean) for v in variants)
    found = np.array([evaluation.formula(plain).at[0] for evaluation in evaluations])
    return found, found


def _ends(
    formula: f.Formula, grids: GridSignals, semantics: Semantics, *, boolean: bool
) -> tuple[FloatArray, FloatArray]:
    plain = strengthened(normal_form(formula))
    other = strengthened(normal_form(formula, greatest=True))
    found = []
    for variant in range(grids.variants):
        evaluation = DenseEvaluation(grids, semantics, variant, boolean=boolean)
        lower = DenseBounds(evaluation, plain).bound(plain, "lower")
        upper = DenseBounds(evaluation, other).bound(other, "upper")
        found.append((lower.at[0], upper.at[0]))
    lo, hi = np.array(found).T
    return lo, hi
