"""Smooth robustness: minima and maxima replaced by soft ones, with the gradient by every sample.

The soft minimum is -log(sum(exp(-k x))) / k, the soft maximum its mirror image (Leung, Arechiga,
Pavone: Backpropagation through signal temporal logic specifications, IJRR 2023). As the sharpness
k grows, the value goes to `rho`; a soft extreme of n numbers is off by log(n) / k at most.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...diagnostics import Code
from ..errors import check_positive, stl_error
from ..formula import formulas as f
from ..formula.variables import variables_of
from . import graph_operations as o
from .axis import SamplePositions
from .evaluation import finite_first
from .graph import FormulaGraph
from .order_statistics import greatest_level
from .schedule import EvaluationPlan, ScheduledStep
from .sliding_and_until import LEAST
from .trace import FloatArray, Positions, SampledSignals, Signals
from .weights import WeighedWindows
from .windows import IntArray, Windows

Backward = Callable[[FloatArray], tuple[FloatArray, ...]]
"""From the gradient by a node to the gradients by its inputs."""


class Smooth(NamedTuple):
    """The smooth robustness at the first sample, a scalar or (V,), and its derivative by each
    signal's samples."""

    rho: Any
    gradient: dict[str, FloatArray]


def smooth_rho(
    formula: f.Formula,
    positions: Positions,
    signals: Signals,
    *,
    sharpness: float = 10.0,
    wrap: float | None = None,
) -> Smooth:
    """Smooth robustness; `sharpness` is 1 / (units of the robustness).

    Gradients have shape (S,), or (1,) for a signal that is one number; of a batch, (V, S) or
    (V, 1), also for a signal that all variants share. Raises DiagnosticError as `rho` does, and
    RL343 for terms without a derivative rule (`^`).
    """
    check_positive(sharpness=sharpness)
    trace = SampledSignals.of(positions, signals, variables_of(formula), wrap)
    axis = SamplePositions.of(trace.positions, wrap)

    def value(infinite: bool) -> list[Smooth]:
        graph = FormulaGraph.of(formula, infinite_signals=infinite)
        plan = EvaluationPlan.of(graph, axis, (0, 0))
        return [_Tape(trace.alone(row), sharpness).run(plan) for row in range(trace.variants)]

    found = finite_first(value)
    if not trace.batched:
        return found[0]
    names = found[0].gradient
    gradient = {name: np.stack([each.gradient[name] for each in found]) for name in names}
    return Smooth(np.array([each.rho for each in found]), gradient)


@dataclass
class _Tape:
    """Computes a plan forward and remembers how to go back."""

    trace: SampledSignals
    sharpness: float

    def run(self, plan: EvaluationPlan) -> Smooth:
        values: list[FloatArray] = []
        backwards: list[Backward | None] = []
        for step in plan.steps:
            value, backward = self._forward(plan, step, values) if step else (np.zeros(1), None)
            values.append(value)
            backwards.append(backward)
        gradients = [np.zeros_like(value) for value in values]
        gradients[-1][...] = 1.0
        by_name: dict[str, FloatArray] = {}
        for index in range(len(plan.steps) - 1, -1, -1):
            step, backward = plan.steps[index], backwards[index]
            if step is None:
                continue
            if isinstance(step.node.operation, o.Read):
                by_name[step.node.operation.name] = self._placed(step, gradients[index])
            if backward is not None:
                parts = backward(gradients[index])
                for source, need, part in zip(step.node.inputs, step.needs, parts, strict=True):
                    _add(gradients[source], plan.steps[source], need, part)
        return Smooth(float(values[-1][0]), by_name)

    def _placed(self, step: ScheduledStep, gradient: FloatArray) -> FloatArray:
        assert isinstance(step.node.operation, o.Read)
        samples = self.trace.signals[step.node.operation.name].shape[1]
        placed = np.zeros(samples)
        first = 0 if samples == 1 else step.span[0]
        placed[first : first + gradient.size] = gradient
        return placed

    def _forward(
        self, plan: EvaluationPlan, step: ScheduledStep, values: list[FloatArray]
    ) -> tuple[FloatArray, Backward | None]:
        match step.node.operation:
            case o.NumberOperation(value):
                return np.full(1, value), None
            case o.Read(name):
                read = self.trace.rows if plan.infinite else self.trace.finite_rows
                row = read(name, 0, 1)[0]
                return (row if row.size == 1 else row[step.span[0] : step.span[1] + 1]), None
        inputs = []
        for source, need in zip(step.node.inputs, step.needs, strict=True):
            known = plan.steps[source]
            if need is None or known is None:
                inputs.append(np.empty(0))
                continue
            start = need[0] - known.span[0]
            source_values = values[source]
            inputs.append(
                source_values
                if source_values.size == 1
                else source_values[start : start + _length(need)]
            )
        match step.node.operation:
            case o.PointwiseOperation(function):
                return self._pointwise(function, inputs)
            case o.Sliding(extreme):
                if step.windows is None:
                    return np.full(1, extreme.identity), None
                sign = -1.0 if extreme is LEAST else 1.0
                return self._slide(inputs[0], step.windows, sign)
            case o.Measuring():
                if step.weighed is None:
                    return np.full(1, -np.inf), None
                return _level(inputs[0], step.weighed[0], step.windows)
            case o.Reaching():
                if step.windows is None:
                    return np.full(1, -np.inf), None
                return self._until(inputs[0], inputs[1], step.windows)
        raise TypeError(f"not an operation: {step.node.operation!r}")

    def _pointwise(
        self, function: o.Function, inputs: list[FloatArray]
    ) -> tuple[FloatArray, Backward]:
        if function in (o.least, o.greatest):
            stack = np.stack(np.broadcast_arrays(*inputs))
            value, weights = self._soft(stack, -1.0 if function is o.least else 1.0)
            return value, lambda g: tuple(g * weight for weight in weights)
        rule = _DERIVATIVES.get(function)
        if rule is None:
            raise stl_error(Code.POWER_IN_SMOOTH_ROBUSTNESS)
        with np.errstate(over="ignore"):
            value = function(*inputs)
        return value, lambda g: tuple(g * slope for slope in rule(*inputs))

    def _soft(self, stack: FloatArray, sign: float) -> tuple[FloatArray, FloatArray]:
        """The soft extreme over the first axis, and its derivatives; sign +1 for the greatest."""
        hard = stack.max(axis=0) if sign > 0 else stack.min(axis=0)
        center = np.where(np.isfinite(hard), hard, 0.0)
        with np.errstate(invalid="ignore", over="ignore"):
            shares = np.exp(sign * self.sharpness * (stack - center))
        total = shares.sum(axis=0)
        finite = np.isfinite(hard)
        safe = np.where(finite, total, 1.0)
        value = np.where(finite, center + sign * np.log(safe) / self.sharpness, hard)
        return value, np.where(finite, shares / safe, 0.0)

    def _slide(
        self, values: FloatArray, windows: Windows, sign: float
    ) -> tuple[FloatArray, Backward]:
        """Every window gathered into a column, those that are shorter padded."""
        indices, held = _gathered(windows, windows.starts)
        samples = windows.span[1] - windows.span[0] + 1
        operand = np.broadcast_to(values, (samples,))
        stack = np.where(held, operand[indices], -sign * np.inf)
        value, weights = self._soft(stack, sign)

        def back(gradient: FloatArray) -> tuple[FloatArray, ...]:
            spread = np.zeros(samples)
            ordered = gradient[::-1] if windows.flipped else gradient
            np.add.at(spread, indices, weights * ordered)
            return (spread,)

        return (value[::-1] if windows.flipped else value), back

    def _until(
        self, left: FloatArray, right: FloatArray, windows: Windows
    ) -> tuple[FloatArray, Backward]:
        """max over the witness of min(right there, left on the way), window by window."""
        samples = windows.span[1] - windows.span[0] + 1
        left, right = np.broadcast_to(left, (samples,)), np.broadcast_to(right, (samples,))
        positions = windows.first + np.arange(windows.count)
        indices, inside = _gathered(windows, positions)
        witness = inside & (np.arange(len(indices))[:, None] >= windows.starts - positions)
        k = self.sharpness
        with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
            onward = np.logaddexp.accumulate(np.where(inside, -k * left[indices], -np.inf), axis=0)
            left_cost = np.concatenate([np.full((1, windows.count), -np.inf), onward[:-1]])
            costs = np.logaddexp(left_cost, -k * right[indices])
        stack = np.where(witness, -costs / k, -np.inf)
        value, weights = self._soft(stack, 1.0)

        def back(gradient: FloatArray) -> tuple[FloatArray, ...]:
            ordered = gradient[::-1] if windows.flipped else gradient
            share = weights * ordered
            by_left, by_right = np.zeros(samples), np.zeros(samples)
            at_witness = _shares(witness, -k * right[indices], costs)
            np.add.at(by_right, indices, share * at_witness)
            for step in range(len(indices) - 1):
                later = slice(step + 1, None)
                shares = _shares(witness[later], -k * left[indices[step]], costs[later])
                np.add.at(by_left, indices[step], (share[later] * shares).sum(axis=0))
            return by_left, by_right

        return (value[::-1] if windows.flipped else value), back


def _level(
    operand: FloatArray, weighed: WeighedWindows, windows: Windows | None
) -> tuple[FloatArray, Backward]:
    """An order statistic as it is: its derivative is that of the sample that it is the value of."""
    laps = 1 if windows is None else windows.laps
    values = np.tile(np.broadcast_to(operand, (weighed.weights.size // laps,)), laps)
    level = greatest_level(values[:, None], weighed)[:, 0]
    bounds = zip(weighed.starts, weighed.ends, level, strict=True)
    chosen = np.array(
        [first + np.argmax(np.append(values[first : last + 1], at) == at)
         for first, last, at in bounds]
    )  # fmt: skip
    is_sample = np.isfinite(level) & (chosen <= weighed.ends)

    def back(gradient: FloatArray) -> tuple[FloatArray, ...]:
        spread = np.zeros(values.size)
        np.add.at(spread, chosen[is_sample], np.broadcast_to(gradient, level.shape)[is_sample])
        return (spread.reshape(laps, -1).sum(axis=0),)

    return level, back


def _shares(witness: NDArray[np.bool_], costs: FloatArray, total: FloatArray) -> FloatArray:
    """exp(costs - total), which is at most one, where there is a witness of finite cost."""
    with np.errstate(invalid="ignore"):
        exponents = np.where(witness & np.isfinite(total), costs - total, -np.inf)
    return np.exp(exponents)


def _gathered(windows: Windows, starts: IntArray) -> tuple[IntArray, NDArray[np.bool_]]:
    """Indices (longest window, windows) into the operand from `starts`, and which are inside."""
    longest = int((windows.ends - starts).max()) + 1
    counted = starts + np.arange(longest)[:, None]
    inside = counted <= windows.ends
    samples = windows.span[1] - windows.span[0] + 1
    indices = np.where(inside, counted, 0) % samples
    return (samples - 1 - indices if windows.flipped else indices), inside


def _add(
    target: FloatArray, step: ScheduledStep | None, need: tuple[int, int] | None, part: FloatArray
) -> None:
    """Add a gradient to the samples of the node that it is about."""
    if step is None or need is None:
        return
    if target.size == 1:
        target += part.sum()
        return
    start = need[0] - step.span[0]
    target[start : start + _length(need)] += part


def _length(span: tuple[int, int]) -> int:
    return span[1] - span[0] + 1


_DERIVATIVES: dict[o.Function, Callable[..., tuple[FloatArray | float, ...]]] = {
    o.TERM_FUNCTIONS["+"]: lambda x, y: (1.0, 1.0),
    o.difference: lambda x, y: (1.0, -1.0),
    o.ROBUST["<"]: lambda x, y: (-1.0, 1.0),
    o.TERM_FUNCTIONS["*"]: lambda x, y: (y, x),
    o.quotient: lambda x, y: (o.quotient(np.ones(1), y), o.quotient(-x, y * y)),
    o.negative: lambda x: (-1.0,),
    o.TERM_FUNCTIONS["abs"]: lambda x: (np.sign(x),),
    o.distance: lambda x, y: (np.sign(x - y), np.sign(y - x)),
    o.closeness: lambda x, y: (np.sign(y - x), np.sign(x - y)),
}
_DERIVATIVES |= {
    of_infinities: _DERIVATIVES[function] for function, of_infinities in o.OF_INFINITIES.items()
}
"""The derivatives of a function by each of its inputs."""
