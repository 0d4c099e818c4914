"""Columns that are not numbers yet: what is computed of them is written down on a tape."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin

from ...geometry.arrays import Floats, Integers
from . import operations as do
from .numpy_loops import loop_of
from .tape import NotElementwiseError, Tape

_COMPARISONS = {
    "less": (do.LESS, False),
    "less_equal": (do.LESS_EQUAL, False),
    "greater": (do.LESS, True),
    "greater_equal": (do.LESS_EQUAL, True),
}
"""with whether the two change places"""
_OF_TRUTHS = {
    "bitwise_and": do.AND, "logical_and": do.AND, "bitwise_or": do.OR, "logical_or": do.OR,
    "invert": do.NOT, "logical_not": do.NOT,
}  # fmt: skip


class TracedColumn(NDArrayOperatorsMixin):
    """A column (N,) over all agents, of numbers or of truth values.

    Code that computes arrays of them goes on as it does with arrays, as long as it does not look
    at them. Of what depends on whether any agent is concerned (`np.count_nonzero`), the engine goes
    the way on which some are: that way gives the same bits where nobody is.
    """

    def __init__(
        self, tape: Tape, value: int, is_truth: bool = False, is_row: bool = False
    ) -> None:
        self.tape = tape
        self.value = value
        self.is_truth = is_truth
        self.is_row = is_row
        """whether it is (1, N)"""

    def __array_ufunc__(self, function: np.ufunc, method: str, *inputs: Any, **more: Any) -> Any:
        if method != "__call__" or more:
            raise NotElementwiseError(f"np.{function.__name__} called in another way")
        return _computed(self.tape, function, inputs)

    def __array_function__(self, function: Any, types: Any, inputs: Any, more: Any) -> Any:
        if function is np.where and len(inputs) == 3 and not more:
            return _chosen(self.tape, *inputs)
        if function is np.count_nonzero and not more and self.tape.takes_every_way:
            return 1
        raise NotElementwiseError(f"np.{getattr(function, '__name__', function)} of columns")

    def __array__(self, *_: Any, **__: Any) -> Any:
        raise NotElementwiseError("a column is not an array of numbers yet")

    def __bool__(self) -> bool:
        raise NotElementwiseError("a column is looked at")

    def __len__(self) -> int:
        return self.tape.agents

    def __iter__(self) -> Iterator[TracedColumn]:
        if not self.is_row:
            raise NotElementwiseError("a column is looked at number by number")
        yield TracedColumn(self.tape, self.value, self.is_truth)

    def __getitem__(self, rows: Any) -> TracedColumn:
        if isinstance(rows, slice) and rows == slice(None):
            return self
        if rows is None and not self.is_row:
            return TracedColumn(self.tape, self.value, self.is_truth, is_row=True)
        raise NotElementwiseError("some agents of a column")

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        raise NotElementwiseError(f"`{name}` of a column")

    def copy(self) -> TracedColumn:
        """The same: it does not change."""
        return self

    def astype(self, kind: Any) -> TracedColumn:
        """Truth values as numbers, 0 and 1."""
        if kind is not np.float64:
            raise NotElementwiseError(f"a column of {kind}")
        return TracedColumn(self.tape, self.value)

    def line_frames(self, track: Any) -> Sequence[TracedColumn]:
        """What `poses.line_frames` gives at these arc lengths."""
        takes = [value_of(self.tape, column) for column in (self, *track.places)]
        found = self.tape.put(do.FRAME, takes, gives=5)
        return [TracedColumn(self.tape, value, is_row=self.is_row) for value in found]

    def value_of_cell(
        self, cells: Floats, shift: Integers, track: Any, version: int
    ) -> TracedColumn:
        """What `compiled.looked_up` gives at these arc lengths. `version`: how often `cells` was
        changed so far."""
        self.tape.look_up_in(cells, shift, version)
        last, origin, _, per_meter = track.places
        advance = self - origin
        cell = np.minimum(np.maximum(advance * per_meter, 0.0), last)
        found = self.tape.put(do.VALUE_OF_CELL, [cell.value])
        return TracedColumn(self.tape, found, is_row=self.is_row)


def value_of(tape: Tape, what: Any) -> int:
    """The number of a value on the tape, of a column or a constant."""
    return what.value if isinstance(what, TracedColumn) else tape.value(what)


def _is_truth(what: Any) -> bool:
    if isinstance(what, TracedColumn):
        return what.is_truth
    return isinstance(what, bool | np.bool_) or getattr(what, "dtype", None) == np.bool_


def _computed(tape: Tape, function: np.ufunc, inputs: Sequence[Any]) -> TracedColumn:
    takes = [value_of(tape, what) for what in inputs]
    truths = [_is_truth(what) for what in inputs]
    name, is_row = function.__name__, _is_row(inputs)
    if name in _COMPARISONS:
        operation, swapped = _COMPARISONS[name]
        value = tape.put(operation, takes[::-1] if swapped else takes)
        return TracedColumn(tape, value, True, is_row)
    if name in _OF_TRUTHS and all(truths):
        return TracedColumn(tape, tape.put(_OF_TRUTHS[name], takes), True, is_row)
    if all(truths):
        raise NotElementwiseError(f"np.{name} of truth values")
    if name in do.BY_NAME:
        return TracedColumn(tape, tape.put(do.BY_NAME[name], takes), False, is_row)
    if loop_of(function) is None or function.nout != 1 or function.nin > 2:
        raise NotElementwiseError(f"np.{name} of columns")
    operation = do.CALL_ONE if function.nin == 1 else do.CALL_TWO
    value = tape.put(operation, takes, more=tape.function(function))
    return TracedColumn(tape, value, False, is_row)


def _chosen(tape: Tape, condition: Any, one: Any, other: Any) -> TracedColumn:
    if not _is_truth(condition):
        raise NotElementwiseError("np.where of what is no truth value")
    inputs = condition, one, other
    takes = [value_of(tape, what) for what in inputs]
    is_truth = _is_truth(one) and _is_truth(other)
    return TracedColumn(tape, tape.put(do.WHERE, takes), is_truth, _is_row(inputs))


def _is_row(inputs: Sequence[Any]) -> bool:
    return any(isinstance(what, TracedColumn) and what.is_row for what in inputs)
