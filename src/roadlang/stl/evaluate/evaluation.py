"""Robustness of a formula on a batch of traces, a few rows at a time."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache, lru_cache
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from ..formula import formulas as f
from .axis import SamplePositions
from .graph import FormulaGraph
from .graph_operations import BOOLEAN, ROBUST, Function
from .schedule import EvaluationPlan
from .trace import FloatArray, InfiniteSignal, Positions, SampledSignals, Signals

Result = TypeVar("Result")

KEPT_SAMPLES = 20_000
"""Samples of the longest traces whose plans are kept: windows are two numbers for each of them."""

CHUNK_SAMPLES = 1 << 16
"""Samples of one signal worked on at a time: 512 KiB, so that a few of them fit the cache."""


def rho(
    formula: f.Formula, positions: Positions, signals: Signals, *, wrap: float | None = None
) -> FloatArray:
    """Robustness at the first sample: (V,), or a scalar where no signal has a variant axis."""
    trace = SampledSignals.of(positions, signals, formula.variables, wrap)
    values = at_start(formula, trace, ROBUST)
    return values if trace.batched else values[0]


def robustness(
    formula: f.Formula, positions: Positions, signals: Signals, *, wrap: float | None = None
) -> FloatArray:
    """Robustness at every sample: (V, S), or (S,) where no signal has a variant axis."""
    trace = SampledSignals.of(positions, signals, formula.variables, wrap)
    values = everywhere(formula, trace, ROBUST)
    return values if trace.batched else values[0]


def satisfied(
    formula: f.Formula, positions: Positions, signals: Signals, *, wrap: float | None = None
) -> NDArray[np.bool_]:
    """Boolean satisfaction at the first sample, strictness observed: (V,) or a scalar."""
    trace = SampledSignals.of(positions, signals, formula.variables, wrap)
    values = at_start(formula, trace, BOOLEAN) > 0
    return values if trace.batched else values[0]


def truth(
    formula: f.Formula, positions: Positions, signals: Signals, *, wrap: float | None = None
) -> NDArray[np.bool_]:
    """Boolean satisfaction at every sample: (V, S) or (S,)."""
    trace = SampledSignals.of(positions, signals, formula.variables, wrap)
    values = everywhere(formula, trace, BOOLEAN) > 0
    return values if trace.batched else values[0]


def at_start(
    formula: f.Formula, trace: SampledSignals, leaves: Mapping[str, Function] = ROBUST
) -> FloatArray:
    """The value at the first sample of each variant, (V,)."""
    positions, boolean = _Clock(trace.positions), leaves is BOOLEAN

    def value(infinite: bool) -> FloatArray:
        return _run(_plan_at_start(formula, boolean, positions, trace.wrap, infinite), trace)

    return finite_first(value)


def finite_first(value: Callable[[bool], Result]) -> Result:
    """`value(False)`; where a signal turns out to be infinite, `value(True)`.

    That infinities are 0 apart takes a look at every difference, which nearly no formula needs.
    """
    try:
        return value(False)
    except InfiniteSignal:
        return value(True)


class _Clock:
    """The positions of samples as a key of plans that are kept. The hash of all their bytes would
    take as long as a window's minima, so it is that of the last few."""

    __slots__ = ("content",)

    def __init__(self, positions: FloatArray) -> None:
        self.content = positions.tobytes()

    def __hash__(self) -> int:
        return hash(self.content[-64:])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Clock) and self.content == other.content

    @property
    def positions(self) -> FloatArray:
        """The positions, read-only."""
        return np.frombuffer(self.content)


@lru_cache(maxsize=256)
def _plan_at_start(
    formula: f.Formula, boolean: bool, clock: _Clock, wrap: float | None, infinite: bool
) -> EvaluationPlan:
    """Kept, as batch after batch of candidates is evaluated on the same stations."""
    axis = SamplePositions.of(clock.positions, wrap)
    return EvaluationPlan.of(
        FormulaGraph.of(formula, BOOLEAN if boolean else ROBUST, infinite), axis, (0, 0)
    )


def run_at_start(
    graph: FormulaGraph,
    trace: SampledSignals,
    axis: SamplePositions,
    *,
    reverse_empty: bool = False,
    sample: int = 0,
) -> FloatArray:
    """The last node of `graph` at the first sample of each variant, or at another, (V,)."""
    span = (sample, sample)
    return _run(EvaluationPlan.of(graph, axis, span, reverse_empty=reverse_empty), trace)


def reversed_at_start(
    formula: f.Formula, trace: SampledSignals, leaves: Mapping[str, Function] = ROBUST
) -> FloatArray:
    """As `at_start`, with windows between two samples counted the other way, (V,)."""
    axis = SamplePositions.of(trace.positions, trace.wrap)

    def value(infinite: bool) -> FloatArray:
        graph = FormulaGraph.of(formula, leaves, infinite)
        return run_at_start(graph, trace, axis, reverse_empty=True)

    return finite_first(value)


def _run(plan: EvaluationPlan, trace: SampledSignals) -> FloatArray:
    result = np.empty(trace.variants)
    for first, last in _chunks(trace, plan):
        result[first:last] = plan.run(trace, first, last)[0]
    return result


def everywhere(
    formula: f.Formula, trace: SampledSignals, leaves: Mapping[str, Function] = ROBUST
) -> FloatArray:
    """The value at every sample of each variant, (V, S)."""
    kept = (leaves is ROBUST or leaves is BOOLEAN) and trace.samples <= KEPT_SAMPLES

    def value(infinite: bool) -> FloatArray:
        if kept:
            clock = _Clock(trace.positions)
            plan = _plan_everywhere(formula, leaves is BOOLEAN, clock, trace.wrap, infinite)
        else:
            plan = _everywhere(formula, leaves, trace.positions, trace.wrap, infinite)
        result = np.empty((trace.variants, trace.samples))
        for first, last in _chunks(trace, plan):
            result[first:last] = plan.run(trace, first, last).T
        return result

    return finite_first(value)


@lru_cache(maxsize=128)
def _plan_everywhere(
    formula: f.Formula, boolean: bool, clock: _Clock, wrap: float | None, infinite: bool
) -> EvaluationPlan:
    """Kept, as trace after trace of one clock is evaluated: the drives of a search have perhaps 60
    lengths, and two formulas each."""
    leaves = BOOLEAN if boolean else ROBUST
    return _everywhere(formula, leaves, clock.positions, wrap, infinite)


def _everywhere(
    formula: f.Formula,
    leaves: Mapping[str, Function],
    positions: FloatArray,
    wrap: float | None,
    infinite: bool,
) -> EvaluationPlan:
    axis = SamplePositions.of(positions, wrap)
    graph = FormulaGraph.of(formula, leaves, infinite)
    return EvaluationPlan.of(graph, axis, (0, len(positions) - 1))


def _chunks(trace: SampledSignals, plan: EvaluationPlan) -> Iterator[tuple[int, int]]:
    """Ranges of variants that are evaluated together."""
    _keep_freed_memory()
    size = CHUNK_SAMPLES if plan.time_major else 2 * CHUNK_SAMPLES
    rows = max(1, size // max(plan.width, trace.samples // 4))
    for first in range(0, trace.variants, rows):
        yield first, min(first + rows, trace.variants)


@cache
def _keep_freed_memory() -> None:
    """Let the C library reuse the arrays of one chunk for the next.

    glibc returns every block above 128 KiB to the system, and faults it in page by page when it is
    requested again, which took four fifths of the time. It raises that limit to the greatest block
    (up to 32 MiB) that it has seen freed; an untouched one costs nothing.
    """
    np.empty(31 << 17)
