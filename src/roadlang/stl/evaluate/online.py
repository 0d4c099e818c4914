"""A monitor that takes samples as they come and always knows what it can and cannot say."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from ...diagnostics import Code, arguments
from ..errors import stl_error
from ..formula import formulas as f
from ..formula.horizon import horizon, looks_at_neighbors, memory
from ..formula.terms import number_text
from ..formula.variables import variables_of
from .position_text import position_text
from .ranges import range_at_start
from .trace import FloatArray, SampledSignals
from .verdicts import Verdict, verdicts_of

_SETTLED_AT_ONCE = 64


class OnlineMonitor:
    """Watches the robustness of one formula at the first sample of a growing trace.

    For `always p` and `eventually p` without bounds, samples that can no longer change `p` are
    folded into one number, so that a step costs as much as `p` looks ahead and back, and memory
    does not grow. Of other formulas all samples are kept.
    """

    def __init__(self, formula: f.Formula) -> None:
        self.formula = formula
        self.lo, self.hi = -math.inf, math.inf
        self.verdict: Verdict = "unknown"
        self._names = sorted(variables_of(formula))
        self._positions: list[float] = []
        self._values: dict[str, list[float]] = {name: [] for name in self._names}
        self._settled: float | None = None
        self._settled_truth: bool | None = None
        self._foldable = _is_foldable(formula)
        self._present = 0

    def __repr__(self) -> str:
        lo, hi = number_text(self.lo), number_text(self.hi)
        return f"<OnlineMonitor of {self.formula}: {self.verdict}, robustness in [{lo}, {hi}]>"

    def push(self, position: float, values: Mapping[str, float]) -> tuple[float, float]:
        """Take the next sample; return [lo, hi] over all continuations of what was seen.

        Raises DiagnosticError RL301 to RL304 for a sample that does not fit, and forgets it.
        """
        position = arguments.number("position", position)
        if self._positions and not position > self._positions[-1]:
            pair = " is followed by ".join(
                position_text(place) for place in (self._positions[-1], position)
            )
            raise stl_error(Code.INVALID_POSITIONS, problem=pair)
        trace = SampledSignals.of([position], values, self._names)
        trace.check()
        for name, sample in trace.signals.items():
            if sample.size != 1:
                shape = np.shape(values[name])
                raise stl_error(
                    Code.WRONG_SIGNAL_SHAPE, what=f"`{name}`", expected="be one number",
                    found=f"has shape {shape}",
                )  # fmt: skip
        self._positions.append(position)
        for name, sample in trace.signals.items():
            self._values[name].append(float(sample[0, 0]))
        self._update()
        return self.lo, self.hi

    def _update(self) -> None:
        trace = self._trace()
        ends = range_at_start(self.formula, trace, sample=self._present)
        verdicts = verdicts_of(self.formula, trace, ends, sample=self._present)
        verdict: Verdict = verdicts[0].item()
        lo, hi = (float(end[0]) for end in ends)
        if self._settled is not None:
            assert isinstance(self.formula, f.UnaryTemporal)
            fatal = self.formula.least
            join = min if fatal else max
            lo, hi = join(lo, self._settled), join(hi, self._settled)
            if self._settled_truth is not fatal:
                verdict = "violated" if fatal else "satisfied"
        self.lo, self.hi, self.verdict = lo, hi, verdict
        if self._foldable:
            self._fold(trace)

    def _fold(self, trace: SampledSignals) -> None:
        """Settle the samples whose windows have ended, many at a time."""
        assert isinstance(self.formula, f.UnaryTemporal)
        body = self.formula.operand
        ahead = horizon(body)
        settled = int(np.searchsorted(trace.positions, trace.positions[-1] - ahead * (1 + 1e-6)))
        if settled - self._present < _SETTLED_AT_ONCE:
            return
        ended = slice(self._present, settled)
        signals = {name: np.asarray(self._values[name]) for name in self._names}
        rho = body.robustness(trace.positions, signals)[ended]
        truth = body.truth(trace.positions, signals)[ended]
        least = self.formula.least
        known = () if self._settled is None else (self._settled,)
        self._settled = min(*known, *rho.tolist()) if least else max(*known, *rho.tolist())
        truths = () if self._settled_truth is None else (self._settled_truth,)
        self._settled_truth = all((*truths, *truth)) if least else any((*truths, *truth))
        self._forget(trace.positions, settled, memory(body))

    def _forget(self, positions: FloatArray, settled: int, back: float) -> None:
        """Drop the samples that the first one that is not settled does not look back at."""
        oldest = positions[settled] - back * (1 + 1e-6)
        first = max(int(np.searchsorted(positions, oldest)) - 1, 0) if back else settled
        del self._positions[:first]
        for column in self._values.values():
            del column[:first]
        self._present = settled - first

    def _trace(self) -> SampledSignals:
        signals = {name: np.asarray(values) for name, values in self._values.items()}
        return SampledSignals.of(self._positions, signals, self._names)


def _is_foldable(formula: f.Formula) -> bool:
    if not isinstance(formula, f.UnaryTemporal) or formula.interval is not None:
        return False
    if looks_at_neighbors(formula) or formula.past:
        return False
    return math.isfinite(horizon(formula.operand) + memory(formula.operand))
