"""Why a formula has its robustness: the sub-formulas, samples and comparisons that decide."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from ...syntax.operators import words
from ..evaluate.axis import SamplePositions
from ..evaluate.evaluation import everywhere
from ..evaluate.graph_operations import BOOLEAN
from ..evaluate.position_text import position_text
from ..evaluate.ranges import range_at_start
from ..evaluate.trace import FloatArray, Positions, SampledSignals, Signals
from ..evaluate.vacuity import empty_operators
from ..evaluate.verdicts import Verdict, finished_verdicts, verdicts_of
from ..formula import formulas as f
from .causes import ViolationInterval, violated_stretches

MEASURE_WORDS = words("measure")


@dataclass(frozen=True)
class Link:
    """A sub-formula at the sample where its robustness is the robustness of the whole."""

    formula: str
    position: float
    rho: float


@dataclass(frozen=True)
class Explanation:
    """`chain` leads from the formula to the comparison that decides; `stretches` are all the
    stretches where a comparison fails that the formula would have needed; `values` are the
    signals of the deciding comparison at `position`. `window_empty`: what decides is that an
    operator has no sample to look at. `between_samples` are the operators with a window that
    falls between two samples, `beyond_end` those whose windows all begin after the end of a trace
    that is finished; a verdict that depends on them is vacuous.
    """

    formula: str
    rho: float
    range: tuple[float, float]
    verdict: Verdict
    chain: tuple[Link, ...]
    position: float
    predicate: str
    values: dict[str, float]
    window_empty: bool
    stretches: tuple[ViolationInterval, ...]
    between_samples: tuple[str, ...] = ()
    beyond_end: tuple[str, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """Plain dicts, lists and numbers; infinities as the texts "inf" and "-inf"."""
        value: dict[str, Any] = _finite(asdict(self))
        return value

    def __str__(self) -> str:
        return "\n".join(self.lines())

    def lines(self) -> list[str]:
        """The explanation in words, one finding a line."""
        rho, lo, hi = (f"{value + 0.0:.6g}" for value in (self.rho, *self.range))  # -0.0 is 0
        lines = [f"{self.verdict}: robustness {rho}, range [{lo}, {hi}]"]
        place = position_text(self.position)
        if self.window_empty:
            lack = "too few samples" if self.predicate.startswith(MEASURE_WORDS) else "no sample"
            lines.append(f"decided at {place}: {lack} in the window of {self.predicate}")
        else:
            values = ", ".join(f"{name} = {value:.6g}" for name, value in self.values.items())
            lines.append(
                f"decided at {place}: {self.predicate}" + f", where {values}" * bool(values)
            )
        for interval in self.stretches:
            start, end, worst = map(
                position_text, (interval.start, interval.end, interval.worst_position)
            )
            lines.append(
                f"from {start} to {end} not {interval.predicate}, "
                f"worst {interval.worst:.6g} at {worst}"
            )
        return lines


def explain(
    formula: f.Formula,
    positions: Positions,
    signals: Signals,
    *,
    variant: int = 0,
    wrap: float | None = None,
    finished: bool = False,
) -> Explanation:
    """Explain the robustness at the first sample of one variant."""
    trace = SampledSignals.of(positions, signals, formula.variables, wrap).alone(variant)
    lo, hi = ends = range_at_start(formula, trace)
    verdicts = finished_verdicts(formula, trace) if finished else verdicts_of(formula, trace, ends)
    between, beyond = empty_operators(formula, trace.positions, wrap)
    finder = _Finder(trace)
    chain, empty = finder.chain(formula)
    last, sample = chain[-1]
    names = sorted(last.variables) if isinstance(last, f.Comparison) else []
    values = {
        name: float(np.broadcast_to(trace.rows(name, 0, 1)[0], trace.samples)[sample])
        for name in names
    }
    return Explanation(
        formula=str(formula),
        rho=finder.value(formula, 0),
        range=(float(lo[0]), float(hi[0])),
        verdict=verdicts[0].item(),
        chain=tuple(
            Link(str(part), float(trace.positions[at]), finder.value(part, at))
            for part, at in chain
        ),
        position=float(trace.positions[sample]),
        predicate=str(last),
        values=values,
        window_empty=empty,
        stretches=violated_stretches(formula, trace),
        between_samples=tuple(map(str, between)),
        beyond_end=tuple(map(str, beyond)) * finished,
    )


def decider(
    formula: f.Formula, positions: Positions, signals: Signals
) -> tuple[frozenset[str], int]:
    """The variables of the comparison, and the sample, that decide the robustness at the first
    sample of a single trace."""
    trace = SampledSignals.of(positions, signals, formula.variables, None).alone(0)
    comparison = _always(formula)
    if comparison is not None:  # as nearly all expectations
        return comparison.variables, int(everywhere(comparison, trace)[0].argmin())
    chain, _ = _Finder(trace).chain(formula)
    last, sample = chain[-1]
    return last.variables, sample


def first_cause(
    formula: f.Formula, positions: Positions, signals: Signals
) -> tuple[frozenset[str], int]:
    """As `decider`, of the first comparison that fails although the formula would have needed it.

    What decides, where there is none, and where something has not come about at any time (of
    `eventually p`, the sample at which p is nearest to true: p fails from the start on).
    """
    trace = SampledSignals.of(positions, signals, formula.variables, None).alone(0)
    comparison = _always(formula)
    if comparison is not None:  # in a fifth of the time
        fails = everywhere(comparison, trace, BOOLEAN)[0] <= 0.0
        if fails.any():
            return comparison.variables, int(fails.argmax())
    chain, _ = _Finder(trace).chain(formula)
    stretches = () if _waits([part for part, _ in chain]) else violated_stretches(formula, trace)
    if not stretches:
        return chain[-1][0].variables, chain[-1][1]
    first = stretches[0]
    return frozenset(first.signals), int(np.searchsorted(trace.positions, first.start))


def _always(formula: f.Formula) -> f.Comparison | None:
    """What has to be true at every sample, where that is a single comparison."""
    if isinstance(formula, f.Always) and formula.interval is None:
        operand = formula.operand
        return operand if isinstance(operand, f.Comparison) else None
    return None


def _waits(chain: list[f.Formula]) -> bool:
    """Whether the first temporal operator on the way to the comparison that decides is one that a
    single moment would satisfy."""
    is_positive = True
    for whole, part in pairwise(chain):
        if isinstance(whole, f.UnaryTemporal):
            return whole.least != is_positive
        if isinstance(whole, f.Pointwise):
            trend = whole.trends[whole.parts.index(part)]
            if trend == 0:
                return False
            is_positive = is_positive == (trend > 0)
        elif not isinstance(whole, f.Derived):
            return False
    return False


class _Finder:
    """Follows the extremes from the root down; traces of sub-formulas are computed once."""

    def __init__(self, trace: SampledSignals) -> None:
        self.trace = trace
        self.axis = SamplePositions.of(trace.positions, trace.wrap)
        self._traces: dict[f.Formula, FloatArray] = {}

    def values(self, formula: f.Formula) -> FloatArray:
        if formula not in self._traces:
            self._traces[formula] = everywhere(formula, self.trace)[0]
        return self._traces[formula]

    def value(self, formula: f.Formula, sample: int) -> float:
        return float(self.values(formula)[sample])

    def chain(self, formula: f.Formula) -> tuple[list[tuple[f.Formula, int]], bool]:
        """Sub-formulas and samples down to what decides, and whether that is an empty window."""
        links = [(formula, 0)]
        while not isinstance(links[-1][0], f.Comparison | f.Truth):
            following = self._next(*links[-1])
            if following is None:
                return links, bool(links[-1][0].parts)
            links.append(following)
        return links, False

    def _next(self, formula: f.Formula, sample: int) -> tuple[f.Formula, int] | None:
        match formula:
            case f.AtLeast():
                return self._level(formula, sample)
            case f.Pointwise():
                return self._deciding_part(formula, sample)
            case f.Derived():
                return formula.expanded(), sample
            case f.BinaryTemporal():
                return self._decider(formula, sample)
            case f.UnaryTemporal() | f.SampleStep():
                return self._extreme(formula, sample)
        raise TypeError(f"not a formula of others: {formula!r}")

    def _deciding_part(self, formula: f.Pointwise, sample: int) -> tuple[f.Formula, int] | None:
        """The first part whose robustness is that of the formula, its sign turned or not."""
        rho = self.value(formula, sample)
        for part, trend in zip(formula.parts, formula.trends, strict=True):
            value = self.value(part, sample)
            if rho in ((value, -value) if trend == 0 else (trend * value,)):
                return part, sample
        return None

    def _extreme(
        self, formula: f.UnaryTemporal | f.SampleStep, sample: int
    ) -> tuple[f.Formula, int] | None:
        windows = self.axis.windows(formula.reach, (sample, sample), past=formula.past)
        if windows is None:
            return None
        held = windows.samples(0)
        values = self.values(formula.operand)[held]
        least = isinstance(formula, f.UnaryTemporal) and formula.least
        extreme = np.argmin(values) if least else np.argmax(values)
        return formula.operand, int(held[extreme])

    def _level(self, formula: f.AtLeast, sample: int) -> tuple[f.Formula, int] | None:
        """The sample of the window whose level is that of the formula."""
        windows = self.axis.windows(formula.interval, (sample, sample), past=False)
        if windows is None:
            return None
        held = windows.samples(0)
        at_level = held[self.values(formula.operand)[held] == self.value(formula, sample)]
        return (formula.operand, int(at_level[0])) if at_level.size else None

    def _decider(self, formula: f.BinaryTemporal, sample: int) -> tuple[f.Formula, int] | None:
        """The best witness, and whether it or a sample on the way to it decides."""
        span = (sample, sample)
        windows = self.axis.windows(formula.reach, span, past=formula.past, path=True)
        if windows is None:
            return None
        held = windows.samples(0)
        left, right = self.values(formula.left), self.values(formula.right)
        path = windows.before(0, held.size)
        lead = path.size - held.size
        reached = np.minimum.accumulate(np.append(np.inf, left[path]))[lead : lead + held.size]
        best = int(np.argmax(np.minimum(right[held], reached)))
        if right[held[best]] <= reached[best]:
            return formula.right, int(held[best])
        path = path[: lead + best]
        return formula.left, int(path[np.argmin(left[path])])


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(part) for key, part in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(part) for part in value]
    if isinstance(value, float) and not np.isfinite(value):
        return str(value)
    return value
