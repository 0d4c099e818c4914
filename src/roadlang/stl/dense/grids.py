"""Signals that are sampled at times of their own, as functions of one common time."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from ...diagnostics import Code, arguments
from ..errors import stl_error
from ..evaluate.axis import TOLERANCE
from ..evaluate.position_text import position_text
from ..evaluate.trace import FloatArray, Positions, SampledSignals, checked_positions
from .piecewise import PiecewiseLinear


@dataclass(frozen=True)
class OwnGrid:
    """A signal with positions of its own: `values` (S,) at `positions` (S,)."""

    positions: Any
    values: Any


GridsOrSignals: TypeAlias = Mapping[str, Any]
"""Signals of a common grid, and `OwnGrid`s."""


@dataclass(frozen=True)
class GridSignals:
    """`traces` has, for each signal, the trace that it is a column of. Time is counted from
    `origin`, the first moment that all signals are known at; `span` is (0, the last one)."""

    traces: Mapping[str, SampledSignals]
    origin: float
    span: FloatArray
    tolerance: float
    variants: int
    batched: bool

    @classmethod
    def of(cls, positions: Positions, signals: GridsOrSignals, names: Iterable[str]) -> GridSignals:
        """Check the signals called `names`. Raises DiagnosticError RL300 to RL304."""
        names = sorted(names)
        arguments.mapping("signals", signals, keys=names)
        common = {name: value for name, value in signals.items() if not isinstance(value, OwnGrid)}
        traces: dict[str, SampledSignals] = {}
        for name in names:
            value = signals.get(name)
            if isinstance(value, OwnGrid):
                traces[name] = SampledSignals.of(value.positions, {name: value.values}, [name])
            else:
                traces[name] = SampledSignals.of(positions, common or signals, [name])
        # A number is known at all times.
        stations = [
            trace.positions for name, trace in traces.items() if name not in trace.constants
        ] or [checked_positions(positions)]
        first = max(float(grid[0]) for grid in stations)
        last = min(float(grid[-1]) for grid in stations)
        if first > last:
            problem = f"a signal ends at {position_text(last)}, before another begins"
            raise stl_error(Code.INVALID_POSITIONS, problem=problem)
        finest = min((float(np.median(np.diff(g))) for g in stations if g.size > 1), default=1.0)
        tolerance = TOLERANCE * TOLERANCE * finest + 4 * math.ulp(max(abs(first), abs(last)))
        span = np.array([0.0, last - first] if last > first else [0.0])
        shared = [trace for trace in traces.values() if trace.batched]
        return cls(
            traces,
            first,
            span,
            tolerance,
            max((trace.variants for trace in traces.values()), default=1),
            bool(shared),
        )

    def checked(self, positions: Positions) -> FloatArray:
        """Positions as times. Raises DiagnosticError RL301 for one outside of the span."""
        times = checked_positions(positions) - self.origin
        outside = (times < -self.tolerance) | (times > self.span[-1] + self.tolerance)
        if outside.any():
            place = position_text(float(times[outside][0]) + self.origin)
            raise stl_error(Code.INVALID_POSITIONS, problem=f"not every signal is known at {place}")
        return times

    def longest_step(self, name: str) -> float:
        """The greatest distance of two neighboring samples of a signal; 0 for a number."""
        trace = self.traces[name]
        if name in trace.constants:
            return 0.0
        return float(np.max(np.diff(trace.positions), initial=0.0))

    def constants(self, variant: int) -> dict[str, FloatArray]:
        """The signals that are one number at every moment, each (1,)."""
        found = {}
        for name, trace in self.traces.items():
            if name in trace.constants:
                row = 0 if trace.variants == 1 else variant
                found[name] = np.asarray(trace.rows(name, row, row + 1)[0], dtype=np.float64)[:1]
        return found

    def rounding(self) -> float:
        """How far from its value robustness may be by the rounding of moments in between."""
        sizes = [0.0]
        for name, trace in self.traces.items():
            values = np.abs(trace.rows(name, 0, trace.variants))
            sizes.append(float(np.max(values[np.isfinite(values)], initial=0.0)))
        return 1e-12 * max(sizes)

    def function(self, name: str, variant: int, linear: bool) -> PiecewiseLinear:
        """A signal over the span. Raises DiagnosticError RL302 for infinite values in between
        which nothing is on a line."""
        trace = self.traces[name]
        row = 0 if trace.variants == 1 else variant
        samples = self.span.size if name in trace.constants else trace.samples
        values = np.broadcast_to(trace.rows(name, row, row + 1)[0], (samples,))
        if linear and np.isinf(values).any():
            index = int(np.argmax(np.isinf(values)))
            place = f"position {position_text(float(trace.positions[index]))}"
            raise stl_error(
                Code.NON_FINITE_SIGNAL, name=name, value=float(values[index]), place=place,
                help="an infinite value cannot be interpolated: use `held` or `sampled` semantics",
            )  # fmt: skip
        values = np.asarray(values, dtype=np.float64)
        whole = PiecewiseLinear(
            self.span if name in trace.constants else trace.positions - self.origin,
            values,
            values[:-1],
            values[1:] if linear else values[:-1],
            self.tolerance,
        )
        return self._within_span(whole)

    def _within_span(self, function: PiecewiseLinear) -> PiecewiseLinear:
        times = function.times
        inside = times[(times > self.tolerance) & (times < self.span[-1] - self.tolerance)]
        ends = self.span
        return function.refined(np.concatenate([ends[:1], inside, ends[1:]]))
