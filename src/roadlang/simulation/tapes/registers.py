"""Rows of memory for columns of agents, so that a processor reads them at its fastest."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats
from ..lines.lines import CELL
from . import operations as do
from .instructions import RegisterInstruction

Call = Callable[[], Any]

_LINE = 64
"""Bytes that a processor fetches at once: arithmetic of rows that begin within one is slower."""


def aligned(rows: int, count: int) -> Floats:
    """(rows, count) new numbers; each row begins where memory is fetched at once."""
    each = _LINE // 8
    wide = -(-count // each) * each + each  # not all at the same place of a page
    memory = np.empty(rows * wide + each)
    begin = (-memory.ctypes.data % _LINE) // 8
    found: Floats = memory[begin : begin + rows * wide].reshape(rows, wide)[:, :count]
    return found


def shared(column: Floats) -> Any:
    """() the number that all of a column (N,) are, to the last bit: arithmetic with it is faster.
    None where they differ."""
    whole = np.ascontiguousarray(column, dtype=np.float64).view(np.int64)
    is_one = len(whole) > 0 and not np.count_nonzero(whole != whole[0])
    return np.array(column[0], dtype=np.float64) if is_one else None


@dataclass
class Registers:
    """The memory of a program for some agents: of each register numbers, truth values, or both."""

    count: int
    """agents"""
    numbers: dict[int, Any]
    """(N,) or () by register"""
    truths: dict[int, Booleans] = field(default_factory=dict)
    _has_number: set[int] = field(default_factory=set)
    _has_truth: set[int] = field(default_factory=set)
    _spare: dict[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._has_number = set(self.numbers)

    def number(self, register: int, calls: list[Call]) -> Any:
        """The numbers in a register, after calls that put them there."""
        if register not in self._has_number:
            calls.append(partial(np.copyto, self._row(register), self.truths[register]))
            self._has_number.add(register)
        return self.numbers[register]

    def truth(self, register: int, calls: list[Call]) -> Booleans:
        """The truth values in a register, after calls that put them there."""
        if register not in self._has_truth:
            into = self._truth_row(register)
            calls.append(partial(np.greater, self.numbers[register], _HALF, into))
            self._has_truth.add(register)
        return self.truths[register]

    def is_truth(self, register: int) -> bool:
        """Whether there are no numbers in a register."""
        return register not in self._has_number

    def for_number(self, register: int) -> Floats:
        """Where numbers are put."""
        self._has_number.add(register)
        self._has_truth.discard(register)
        return self._row(register)

    def for_truth(self, register: int) -> Booleans:
        """Where truth values are put."""
        self._has_truth.add(register)
        self._has_number.discard(register)
        return self._truth_row(register)

    def spare(self, name: str) -> Any:
        """(N,) numbers for use within one instruction: `cells` are whole, `pairs` complex, `table`
        has a row of as many as there are in a cell of the table of lines."""
        if name not in self._spare:
            self._spare[name] = _row_of(name, self.count)
        return self._spare[name]

    def as_row(self, number: Any) -> Any:
        """(N,) of a number that may be one for all: the lesser and the greater of two are found
        faster of rows."""
        if number.ndim:
            return number
        name = f"row of {number!r}"
        if name not in self._spare:
            self._spare[name] = aligned(1, self.count)[0]
            self._spare[name][:] = number
        return self._spare[name]

    def before(
        self, condition: int, inside: Sequence[RegisterInstruction], calls: list[Call]
    ) -> tuple[set[int], set[int]]:
        """What there is before instructions that are left out where a condition is true of nobody,
        after calls that put there the numbers over which choices by it write."""
        for one in inside:
            if one.operation == do.WHERE and one.takes[0] == condition:
                self.number(one.takes[2], calls)
                self._has_truth.discard(one.takes[2])
        return {*self._has_number}, {*self._has_truth}

    def put_results(self, gives: Sequence[int], rows: Sequence[Floats]) -> None:
        """Registers whose numbers are not there yet, the last of which a program comes to, are
        these rows: before its calls are made. Nothing else may need what is in the rows."""
        for register, row in zip(gives, rows, strict=True):
            self.numbers.setdefault(register, row)

    def copies(self, gives: Sequence[int], rows: Sequence[Floats]) -> list[Call]:
        """The calls that put what a program has come to into rows in which it is not yet."""
        calls: list[Call] = []
        for register, row in zip(gives, rows, strict=True):
            number = self.number(register, calls)
            if number is not row:
                calls.append(partial(np.copyto, row, number))
        return calls

    def go_back(self, numbers: set[int], truths: set[int]) -> None:
        """Only what was there before counts as there."""
        self._has_number, self._has_truth = numbers, truths

    def _row(self, register: int) -> Floats:
        if register not in self.numbers:
            self.numbers[register] = aligned(1, self.count)[0]
        found: Floats = self.numbers[register]
        return found

    def _truth_row(self, register: int) -> Booleans:
        if register not in self.truths:
            self.truths[register] = np.empty(self.count, dtype=bool)
        return self.truths[register]


def _row_of(name: str, count: int) -> Any:
    if name == "cells":
        return np.empty(count, np.int64)
    if name == "table":
        return aligned(1, count * len(CELL))[0].reshape(count, len(CELL))
    return np.empty(count, np.complex128) if name == "pairs" else aligned(1, count)[0]


_HALF = np.array(0.5)
