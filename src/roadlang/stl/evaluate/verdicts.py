"""Satisfied, violated or unknown: what a trace says about a formula, whatever comes next."""

from __future__ import annotations

from typing import Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..formula import formulas as f
from .operations import BOOLEAN
from .ranges import range_at_start
from .trace import FloatArray, Positions, Signals, Trace

Verdict: TypeAlias = Literal["satisfied", "violated", "unknown"]


class Range(NamedTuple):
    """The least and the greatest robustness over all continuations; arrays (V,) or scalars."""

    lo: FloatArray
    hi: FloatArray


def robustness_range(
    formula: f.Formula, positions: Positions, signals: Signals, *, wrap: float | None = None
) -> Range:
    """[lo, hi] at the first sample."""
    trace = Trace.of(positions, signals, formula.variables, wrap)
    lo, hi = range_at_start(formula, trace)
    return Range(lo, hi) if trace.batched else Range(lo[0], hi[0])


def verdict(
    formula: f.Formula, positions: Positions, signals: Signals, *, wrap: float | None = None
) -> NDArray[np.str_] | Verdict:
    """The verdict of one trace, or an array (V,) of verdicts."""
    trace = Trace.of(positions, signals, formula.variables, wrap)
    verdicts = verdicts_of(formula, trace)
    if trace.batched:
        return verdicts
    alone: Verdict = verdicts[0].item()
    return alone


def verdicts_of(formula: f.Formula, trace: Trace) -> NDArray[np.str_]:
    """Verdicts (V,) at the first sample."""
    return decided(formula, trace, *range_at_start(formula, trace))


def decided(formula: f.Formula, trace: Trace, lo: FloatArray, hi: FloatArray) -> NDArray[np.str_]:
    """Verdicts (V,) by the range (lo, hi), by Boolean evaluation where it ends at zero."""
    verdicts = np.where(lo > 0, "satisfied", np.where(hi < 0, "violated", "unknown"))
    undecided = (lo == 0) | (hi == 0)
    if undecided.any():
        lowest, highest = range_at_start(formula, trace, BOOLEAN)
        told = np.where(lowest > 0, "satisfied", np.where(highest < 0, "violated", "unknown"))
        verdicts = np.where(undecided, told, verdicts)
    return verdicts
