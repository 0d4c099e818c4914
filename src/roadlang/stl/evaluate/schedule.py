"""A graph scheduled for one axis: which samples of each node are needed, and in what windows."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from .axis import SamplePositions
from .graph import FormulaGraph, FormulaNode
from .graph_operations import (
    AtUnseen,
    Extend,
    GivenNumbers,
    Measuring,
    NumberOperation,
    PointwiseOperation,
    Reaching,
    Read,
    Sliding,
)
from .order_statistics import greatest_level
from .sliding_and_until import GREATEST, slide, slide_between, until
from .trace import FloatArray, InfiniteSignal, SampledSignals
from .weights import UnseenWeights, WeighedWindows, weighed_windows
from .windows import BoolArray, Windows

Span = tuple[int, int]


@dataclass(frozen=True)
class ScheduledStep:
    """One node over the samples `span`; `needs` is, per input, the samples that it reads of it."""

    node: FormulaNode
    span: Span
    needs: tuple[Span | None, ...]
    windows: Windows | None = None
    reversed_at: BoolArray | None = None
    """The samples of `span` whose empty window counts the other way."""
    weighed: tuple[WeighedWindows, UnseenWeights | None] | None = None


@dataclass(frozen=True)
class EvaluationPlan:
    """Steps in order; None where a node is not needed. The last one is the result.

    `spent[k]` are the nodes that nothing reads after step k. `time_major`: chunks are copied so
    that the rows of one sample lie side by side in memory, as sliding windows want them.
    `infinite`: signals can be infinite.
    """

    steps: tuple[ScheduledStep | None, ...]
    spent: tuple[tuple[int, ...], ...]
    time_major: bool
    infinite: bool = False

    @classmethod
    def of(
        cls,
        graph: FormulaGraph,
        axis: SamplePositions,
        targets: Span,
        *,
        reverse_empty: bool = False,
    ) -> EvaluationPlan:
        """Schedule the last node of `graph` over the samples `targets` (first, last).

        `reverse_empty`: a window between two samples makes `always` false and `eventually` true.
        """
        needed: dict[int, Span] = {len(graph.nodes) - 1: targets}
        steps: list[ScheduledStep | None] = [None] * len(graph.nodes)
        for index in range(len(graph.nodes) - 1, -1, -1):
            if index not in needed:
                continue
            step = _step(graph.nodes[index], axis, needed[index])
            if reverse_empty:
                step = _reversing(step, axis)
            steps[index] = step
            for source, need in zip(step.node.inputs, step.needs, strict=True):
                if need is not None:
                    known = needed.get(source, need)
                    needed[source] = (min(known[0], need[0]), max(known[1], need[1]))
        windowed = (step.windows for step in steps if step is not None)
        time_major = any(windows is not None and windows.count > 1 for windows in windowed)
        reaching = any(step and isinstance(step.node.operation, Reaching) for step in steps)
        return cls(tuple(steps), _spent(graph), time_major or reaching, graph.infinite)

    @property
    def width(self) -> int:
        """The most samples that any node is computed at."""
        return max(step.span[1] - step.span[0] + 1 for step in self.steps if step is not None)

    def run(self, trace: SampledSignals, first: int, last: int) -> FloatArray:
        """The result for variants first..last-1, shape (targets, rows).

        Raises `InfiniteSignal` where a number is infinite and the plan is not for such.
        """
        # Numbers that overflow become infinite; only the slower functions can add those.
        with np.errstate(over="ignore" if self.infinite else "raise"):
            try:
                return self._result(trace, first, last)
            except FloatingPointError:
                raise InfiniteSignal from None

    def _result(self, trace: SampledSignals, first: int, last: int) -> FloatArray:
        values: list[FloatArray | None] = []
        for step, spent in zip(self.steps, self.spent, strict=True):
            values.append(None if step is None else self._compute(step, values, trace, first, last))
            for index in spent:
                values[index] = None
        result = values[-1]
        assert result is not None
        return result

    def _compute(
        self,
        step: ScheduledStep,
        values: list[FloatArray | None],
        trace: SampledSignals,
        first: int,
        last: int,
    ) -> FloatArray:
        match step.node.operation:
            case NumberOperation(value):
                return np.full((1, 1), value)
            case GivenNumbers(name):
                return trace.unchecked(name, first, last)
            case Read(name):
                low, high = step.span
                read = trace.rows if self.infinite else trace.finite_rows
                rows = read(name, first, last)
                part = rows.T if rows.shape[1] == 1 else rows[:, low : high + 1].T
                return np.ascontiguousarray(part) if self.time_major else part
        inputs = [
            self._slice(values, source, need)
            for source, need in zip(step.node.inputs, step.needs, strict=True)
        ]
        result = _derived(step, inputs)
        return result if step.reversed_at is None else _with_reversed(step, result)

    def _slice(self, values: list[FloatArray | None], source: int, need: Span | None) -> FloatArray:
        step, value = self.steps[source], values[source]
        if need is None or step is None or value is None:
            return np.empty((0, 1))
        if len(value) == 1 or need == step.span:
            return value
        return value[need[0] - step.span[0] : need[1] - step.span[0] + 1]


def _derived(step: ScheduledStep, inputs: list[FloatArray]) -> FloatArray:
    """What a node computes from the samples of its inputs that it needs."""
    windows = step.windows
    match step.node.operation:
        case PointwiseOperation(function):
            return function(*inputs)
        case Sliding(extreme):
            if windows is None:
                return np.full((1, 1), extreme.identity)
            return _turned(slide(_unrolled(inputs[0], windows), windows, extreme), windows)
        case Reaching():
            if windows is None:
                return np.full((1, 1), -np.inf)
            left, right = np.broadcast_arrays(*(_unrolled(values, windows) for values in inputs))
            return _turned(until(left, right, windows), windows)
        case Measuring():
            if windows is None or step.weighed is None:
                return np.full((1, 1), -np.inf)
            return _measured(_unrolled(inputs[0], windows), *step.weighed)
        case Extend():
            filled = [
                np.broadcast_to(values, (need[1] - need[0] + 1, values.shape[1]))
                for values, need in zip(inputs, step.needs, strict=True)
                if need is not None
            ]
            rows = max(values.shape[1] for values in filled)
            return np.concatenate([np.broadcast_to(v, (len(v), rows)) for v in filled])
        case AtUnseen(_, function):
            value, window = inputs
            if step.needs[1] is None:
                return value
            low, high = step.needs[1]
            seen = np.broadcast_to(value, (step.span[1] - step.span[0] + 1, value.shape[1]))
            split = low - step.span[0]
            joined = function(
                seen[split:], np.broadcast_to(window, (high - low + 1, window.shape[1]))
            )
            head = np.broadcast_to(seen[:split], (split, joined.shape[1]))
            return np.concatenate([head, joined])
    raise TypeError(f"not an operation: {step.node.operation!r}")


def _measured(
    values: FloatArray, weighed: WeighedWindows, unseen: UnseenWeights | None
) -> FloatArray:
    level = greatest_level(values, weighed)
    if unseen is None:
        return level
    beyond = slide_between(values, unseen.starts, unseen.ends, GREATEST)
    beyond[~unseen.open] = -np.inf
    rest = replace(weighed, enough=weighed.enough - unseen.more)
    found: FloatArray = np.maximum(level, np.minimum(beyond, greatest_level(values, rest)))
    return found


def _step(node: FormulaNode, axis: SamplePositions, targets: Span) -> ScheduledStep:
    match node.operation:
        case Sliding(_, interval, past) | Reaching(interval, past):
            path = isinstance(node.operation, Reaching)
            windows = axis.windows(interval, targets, past=past, path=path)
            span = None if windows is None else windows.span
            return ScheduledStep(node, targets, (span,) * len(node.inputs), windows)
        case Measuring(interval) as operation:
            windows = axis.windows(interval, targets, past=False)
            if windows is None:
                return ScheduledStep(node, targets, (None,))
            weighed = weighed_windows(axis, windows, operation, targets)
            return ScheduledStep(node, targets, (windows.span,), windows, weighed=weighed)
        case Extend(seen):
            return ScheduledStep(node, targets, (_before(targets, seen), _behind(targets, seen)))
        case AtUnseen(seen):
            return ScheduledStep(node, targets, (targets, _behind(targets, seen)))
    return ScheduledStep(node, targets, (targets,) * len(node.inputs))


def _reversing(step: ScheduledStep, axis: SamplePositions) -> ScheduledStep:
    match step.node.operation:
        case Sliding(_, interval, past) | Reaching(interval, past):
            empty = axis.between_samples(interval, step.span, past=past)
            return replace(step, reversed_at=empty) if empty.any() else step
        case Measuring(interval):
            empty = axis.between_samples(interval, step.span, past=False)
            return replace(step, reversed_at=empty) if empty.any() else step
    return step


def _with_reversed(step: ScheduledStep, values: FloatArray) -> FloatArray:
    assert step.reversed_at is not None
    operation = step.node.operation
    identity = operation.extreme.identity if isinstance(operation, Sliding) else -np.inf
    samples = step.span[1] - step.span[0] + 1
    result = np.array(np.broadcast_to(values, (samples, values.shape[1])))
    result[step.reversed_at] = -identity
    return result


def _before(span: Span, seen: int) -> Span | None:
    return (span[0], min(span[1], seen - 1)) if span[0] < seen else None


def _behind(span: Span, seen: int) -> Span | None:
    return (max(span[0], seen), span[1]) if span[1] >= seen else None


def _spent(graph: FormulaGraph) -> tuple[tuple[int, ...], ...]:
    last_use = {source: k for k, node in enumerate(graph.nodes) for source in node.inputs}
    spent: list[list[int]] = [[] for _ in graph.nodes]
    for source, index in last_use.items():
        spent[index].append(source)
    return tuple(tuple(sources) for sources in spent)


def _unrolled(values: FloatArray, windows: Windows) -> FloatArray:
    """The operand as the windows count it: every sample present, turned, repeated."""
    samples = windows.span[1] - windows.span[0] + 1
    if len(values) != samples:
        values = np.broadcast_to(values, (samples, values.shape[1]))
    if windows.flipped:
        values = values[::-1]
    return np.concatenate([values] * windows.laps) if windows.laps > 1 else values


def _turned(values: FloatArray, windows: Windows) -> FloatArray:
    return values[::-1] if windows.flipped else values
