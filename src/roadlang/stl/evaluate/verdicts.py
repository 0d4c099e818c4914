"""What a trace says about a formula, whatever comes next: satisfied, violated, unknown, vacuous."""

from __future__ import annotations

from functools import cache
from typing import Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..formula import formulas as f
from .axis import SamplePositions
from .beyond_end import TraceEnd
from .evaluation import at_start, reversed_at_start
from .graph_operations import BOOLEAN
from .ranges import range_at_start
from .satisfaction import is_satisfied
from .trace import FloatArray, Positions, SampledSignals, Signals
from .vacuity import empty_operators

Verdict: TypeAlias = Literal["satisfied", "violated", "unknown", "vacuous"]


class Range(NamedTuple):
    """The least and the greatest robustness over all continuations; arrays (V,) or scalars."""

    lo: FloatArray
    hi: FloatArray


def robustness_range(
    formula: f.Formula, positions: Positions, signals: Signals, *, wrap: float | None = None
) -> Range:
    """[lo, hi] at the first sample."""
    trace = SampledSignals.of(positions, signals, formula.variables, wrap)
    lo, hi = range_at_start(formula, trace)
    return Range(lo, hi) if trace.batched else Range(lo[0], hi[0])


def verdict(
    formula: f.Formula,
    positions: Positions,
    signals: Signals,
    *,
    wrap: float | None = None,
    finished: bool = False,
) -> NDArray[np.str_] | Verdict:
    """The verdict of one trace, or an array (V,) of verdicts."""
    trace = SampledSignals.of(positions, signals, formula.variables, wrap)
    verdicts = finished_verdicts(formula, trace) if finished else verdicts_of(formula, trace)
    if trace.batched:
        return verdicts
    alone: Verdict = verdicts[0].item()
    return alone


def verdicts_of(
    formula: f.Formula,
    trace: SampledSignals,
    ends: tuple[FloatArray, FloatArray] | None = None,
    *,
    sample: int = 0,
) -> NDArray[np.str_]:
    """Verdicts (V,) at the first sample, or at another; `ends` is the range, if it is known.

    A verdict is vacuous if it would be another one had every window that falls between two
    samples counted the other way: it says something about the sampling, not about the signals.
    """
    known = ends or range_at_start(formula, trace, sample=sample)
    found = _decided(formula, trace, *known, False, sample)
    if not empty_operators(formula, trace.positions, trace.wrap).between_samples:
        return found
    reverse = range_at_start(formula, trace, reverse_empty=True, sample=sample)
    other = _decided(formula, trace, *reverse, True, sample)
    return np.where((found != "unknown") & (found != other), "vacuous", found)


def finished_verdicts(formula: f.Formula, trace: SampledSignals) -> NDArray[np.str_]:
    """Verdicts (V,) at the first sample of a trace that does not continue: none is unknown.

    One is vacuous if it depends on windows without samples, between two samples or all of an
    operator after the end, unless no continuation changes it.
    """
    rho = at_start(formula, trace)
    holds = is_satisfied(rho, lambda rows: at_start(formula, trace, BOOLEAN)[rows] > 0)
    found = np.where(holds, "satisfied", "violated")
    return np.where(_is_vacuous(formula, trace, holds), "vacuous", found)


def _is_vacuous(
    formula: f.Formula, trace: SampledSignals, holds: NDArray[np.bool_]
) -> NDArray[np.bool_]:
    """(V,) whether verdicts are vacuous; `holds` (V,): whether the formula is satisfied."""
    if not any(empty_operators(formula, trace.positions, trace.wrap)):
        return np.zeros(trace.variants, dtype=bool)
    other = TraceEnd.of(SamplePositions.of(trace.positions, trace.wrap)).reversed(formula)
    reversed_ = is_satisfied(
        reversed_at_start(other, trace),
        lambda rows: reversed_at_start(other, trace, BOOLEAN)[rows] > 0,
    )
    settled = np.isin(verdicts_of(formula, trace), ("satisfied", "violated"))
    return np.asarray((holds != reversed_) & ~settled)


def _decided(
    formula: f.Formula,
    trace: SampledSignals,
    lo: FloatArray,
    hi: FloatArray,
    reverse_empty: bool,
    sample: int,
) -> NDArray[np.str_]:
    """Verdicts (V,) by the range (lo, hi): both ends of it satisfy the formula, none, or one."""

    @cache
    def boolean() -> tuple[FloatArray, FloatArray]:
        return range_at_start(formula, trace, BOOLEAN, reverse_empty=reverse_empty, sample=sample)

    always = is_satisfied(lo, lambda rows: boolean()[0][rows] > 0)
    ever = is_satisfied(hi, lambda rows: boolean()[1][rows] > 0)
    return np.where(always, "satisfied", np.where(ever, "unknown", "violated"))
