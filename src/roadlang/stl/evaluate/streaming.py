"""A monitor of a stream: the robustness at each sample as soon as it is known."""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np

from ...diagnostics import Code, arguments
from ..errors import stl_error
from ..formula import formulas as f
from ..formula.horizon import horizon
from ..formula.interval import UNBOUNDED, NeighborWindow
from ..formula.variables import variables_of
from . import graph_operations as op
from .graph import FormulaGraph
from .graph_operations import (
    Measuring,
    NumberOperation,
    PointwiseOperation,
    Reaching,
    Read,
    Sliding,
)
from .position_text import position_text
from .sliding_and_until import GREATEST
from .stream_measures import StreamMeasure
from .stream_neighbors import StreamNext, StreamPrevious
from .stream_nodes import (
    Clock,
    Stream,
    StreamFutureWindow,
    StreamNode,
    StreamPastWindow,
    StreamPointwise,
    StreamSince,
    StreamUntil,
)


class DecidedSample(NamedTuple):
    """The robustness at the sample at `position`, whatever comes next."""

    position: float
    rho: float


def _bounded(formula: f.Formula) -> tuple[str, ...]:
    """What can be watched in place of a formula that looks ahead without bound."""
    operand = formula.operand if isinstance(formula, f.Always) else None
    alone = operand is not None and not math.isinf(horizon(operand))
    return (
        *((f"to see when it fails, leave `always` out: `{operand}`",) if alone else ()),
        "give the operator an interval with an end, such as `always[0, 5]`, or look back with "
        "`historically`, `once` or `since`",
    )


class StreamMonitor:
    """Gives the robustness of a formula at every sample of a stream.

    Of a formula that looks back, the robustness at the current sample is known at once; one that
    looks ahead is known when its `delay`, the furthest that it looks, has passed. What is given is
    what `formula.robustness` gives on the whole trace. Work and memory depend on the longest
    interval only.

    With `boolean` it is 1 where the formula is satisfied and -1 where it is not, which robustness
    of exactly 0 does not tell. Raises DiagnosticError RL309 for a formula with an unbounded future
    operator.
    """

    def __init__(self, formula: f.Formula, *, boolean: bool = False) -> None:
        self.formula = formula
        self._names = sorted(variables_of(formula))
        self._is_finished = False
        self.delay = horizon(formula)
        if math.isinf(self.delay):
            raise stl_error(Code.UNBOUNDED_FUTURE, formula=str(formula), help=_bounded(formula))
        self._clock = Clock()
        graph = FormulaGraph.of(formula, op.BOOLEAN if boolean else op.ROBUST)
        self._steps = [
            (_source(node.operation), _node(node.operation, len(node.inputs), self._clock),
             node.inputs)
            for node in graph.nodes
        ]  # fmt: skip

    def __repr__(self) -> str:
        samples = f"{self._clock.count} sample{'' if self._clock.count == 1 else 's'}"
        return f"<StreamMonitor of {self.formula}: {samples}, delay {position_text(self.delay)}>"

    def push(self, position: float, values: Mapping[str, float]) -> tuple[DecidedSample, ...]:
        """Take the next sample; return the samples whose robustness has become known, in order.

        Raises DiagnosticError RL301, RL302 or RL304 for a sample that does not fit, and forgets it;
        RuntimeError after `finish`.
        """
        if self._is_finished:
            raise RuntimeError("the stream is finished: make another `StreamMonitor`")
        values = arguments.mapping("values", values, self._names)
        position = arguments.number("position", position)
        place = self._clock.latest + self._clock.first
        if not math.isfinite(position) or (self._clock.count and not position > place):
            pair = f"{position_text(place)} is followed by {position_text(position)}"
            raise stl_error(Code.INVALID_POSITIONS, problem=pair)
        for name in self._names:
            if name not in values:
                raise stl_error(Code.MISSING_SIGNAL, name=name)
            if isinstance(values[name], str):
                text = f"is {str(values[name])!r}"
                what = f"`{name}`"
                raise stl_error(
                    Code.WRONG_SIGNAL_SHAPE, what=what, expected="be numbers", found=text
                )
            if math.isnan(arguments.number(f"values[{name!r}]", values[name])):
                where = f"position {position_text(position)}"
                raise stl_error(Code.NON_FINITE_SIGNAL, name=name, value=values[name], place=where)
        place = self._clock.advance(float(position))
        streams: list[Stream] = []
        for source, node, inputs in self._steps:
            if node is None:
                streams.append([(place, source(values))])
            else:
                streams.append(node.step([streams[index] for index in inputs]))
        return self._decided(streams[-1])

    def finish(self) -> tuple[DecidedSample, ...]:
        """The samples that are left, as if the trace ended here. No sample can follow."""
        self._is_finished = True
        streams: list[Stream] = []
        for _, node, inputs in self._steps:
            fed = [streams[index] for index in inputs]
            streams.append([] if node is None else node.finish(fed))
        return self._decided(streams[-1])

    def _decided(self, stream: Stream) -> tuple[DecidedSample, ...]:
        first = self._clock.first
        return tuple(DecidedSample(first + place, value) for place, value in stream)


def _source(operation: op.Operation) -> Callable[[Mapping[str, float]], float]:
    match operation:
        case Read(name):
            return lambda values: float(values[name])
        case NumberOperation(value):
            return lambda values: value
    return lambda values: math.nan


def _node(operation: op.Operation, inputs: int, clock: Clock) -> StreamNode | None:
    match operation:
        case Read() | NumberOperation():
            return None
        case PointwiseOperation(function):
            return StreamPointwise(_SCALARS[function], inputs)
        case Sliding(_, NeighborWindow(), past):
            return StreamPrevious() if past else StreamNext()
        case Sliding(extreme, interval, past):
            assert not isinstance(interval, NeighborWindow)
            window = StreamPastWindow if past else StreamFutureWindow
            return window(clock, interval or UNBOUNDED, 1 if extreme is GREATEST else -1)
        case Measuring():
            return StreamMeasure(clock, operation)
        case Reaching(interval, past):
            return (StreamSince if past else StreamUntil)(clock, interval or UNBOUNDED)
    raise TypeError(f"not an operation of a formula: {operation!r}")


def _zero_for_nan(value: float) -> float:
    return 0.0 if value != value else value


def _difference(left: float, right: float) -> float:
    return _zero_for_nan(left - right)


def _quotient(left: float, right: float) -> float:
    if right == 0.0:
        return 0.0 if left == 0.0 else math.copysign(math.inf, left)
    return _zero_for_nan(left / right)


def _power(left: float, right: float) -> float:
    return float(op.power(np.float64(left), np.float64(right)))  # type: ignore[arg-type]


def _least(*values: float) -> float:
    return min(values)


def _greatest(*values: float) -> float:
    return max(values)


_SCALARS: dict[op.Function, Callable[..., float]] = {
    op.TERM_FUNCTIONS["+"]: lambda left, right: _zero_for_nan(left + right),
    op.TERM_FUNCTIONS["-"]: _difference,
    op.TERM_FUNCTIONS["*"]: lambda left, right: _zero_for_nan(left * right),
    op.TERM_FUNCTIONS["/"]: _quotient,
    op.TERM_FUNCTIONS["^"]: _power,
    op.TERM_FUNCTIONS["abs"]: abs,
    op.TERM_FUNCTIONS["min"]: _least,
    op.TERM_FUNCTIONS["max"]: _greatest,
    op.negative: lambda value: -value,
    op.ROBUST["<"]: lambda left, right: _difference(right, left),
    op.ROBUST["=="]: lambda left, right: -abs(_difference(left, right)),
    op.ROBUST["!="]: lambda left, right: abs(_difference(left, right)),
}
"""For one sample what the functions of arrays are for many; numbers may be infinite."""


def _truth_of(relation: Callable[[float, float], bool]) -> Callable[..., float]:
    return lambda left, right: 1.0 if relation(left, right) else -1.0


_SCALARS.update(
    {
        op.BOOLEAN["<"]: _truth_of(operator.lt),
        op.BOOLEAN["<="]: _truth_of(operator.le),
        op.BOOLEAN[">"]: _truth_of(operator.gt),
        op.BOOLEAN[">="]: _truth_of(operator.ge),
        op.BOOLEAN["=="]: _truth_of(operator.eq),
        op.BOOLEAN["!="]: _truth_of(operator.ne),
    }
)
_SCALARS.update(
    {
        infinite: _SCALARS[function]
        for function, infinite in op.OF_INFINITIES.items()
        if function in _SCALARS
    }
)
