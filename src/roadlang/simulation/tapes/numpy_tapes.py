"""Programs carried out with numpy, where no compiled loop is there: to the same bits."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from ...geometry.arrays import Floats, Integers
from ..vehicles.frame_calls import frame_calls
from ..vehicles.free_steps import FEWEST, FreeSteps
from ..vehicles.vehicle_steps import step_calls
from . import operations as do
from .instructions import NOWHERE, RegisterInstruction, instructions_of, without_unused
from .numpy_calls import TableRows, calls_of, into
from .registers import Call, Registers, aligned, shared
from .tape import TapeProgram

WIDE = 3072
"""Agents whose registers are computed together, at most."""


class _EndedError(Exception):
    """A number is infinite or NaN that must not be."""


@dataclass
class _Recording:
    """Where samples of some agents are written."""

    samples: Floats
    """(T, Q, N)"""
    next: int
    agents: slice

    def record(self, rows: Sequence[Any]) -> None:
        """Write the next."""
        agents = self.agents
        sample, used = self.samples[self.next], agents.stop - agents.start
        for place, row in enumerate(rows):
            sample[place, agents] = row[:used] if row.ndim else row
        self.next += 1


class NumpyTape:
    """A program, bound to memory; what `interpreting.repeated` does.

    `walks`: whether any agent may; `lines`: the table of their lines, and where it begins for each.
    """

    def __init__(
        self, program: TapeProgram, given: int, lines: tuple[Floats, Integers], walks: bool,
        dt: float,
    ) -> None:  # fmt: skip
        """`given`: columns that the program begins with."""
        self._program, self._dt = program, dt
        table, self._first = lines
        count = len(self._first)
        self._wide = wide = -(-count // max(1, -(-count // WIDE)))
        constants = [shared(column) for column in program.columns]
        self._filled = [number for number, one in enumerate(constants) if one is None]
        """constant columns in which agents differ"""
        self._rows = aligned(given + len(self._filled), wide)
        for number, row in zip(self._filled, self._rows[given:], strict=True):
            constants[number] = row
        self._given, self._walks = given, aligned(1, wide)[0] if walks else None
        self._lines = TableRows.of(table, np.zeros(wide, np.int64))
        self._value_cells = aligned(1, wide)[0]
        """where the values of cells begin"""
        numbers = [*self._rows[:given], *constants, *(np.array(one) for one in program.numbers)]
        self._memory = Registers(wide, dict(enumerate(numbers)))
        # No call holds the tape itself: its memory is free with its last user.
        self._recording = _Recording(np.empty((0, 0, 0)), 0, slice(0, 0))
        steps, self._gives = instructions_of(program, given)
        steps = without_unused(steps, self._gives)
        self._calls = calls_of(steps, program.functions, self._memory, self._lines, self._add)
        self._calls += [
            partial(np.copyto, self._rows[place], self._memory.number(register, self._calls))
            for place, register in enumerate(self._gives[:given])
            if place != register
        ]
        self._results = [self._memory.number(one, self._calls) for one in self._gives]

    def repeated(
        self, state: Floats, walks: Floats, times: int, samples: Floats, out: Floats
    ) -> int:
        """Carry it out `times` times; arguments and result are those of `interpreting.repeated`."""
        self._recording.samples, whole = samples, times
        each = len(samples) // times
        with np.errstate(all="ignore"):
            for begin in range(0, state.shape[1], self._wide):
                agents = slice(begin, min(begin + self._wide, state.shape[1]))
                self._begin(state, walks, agents)
                whole = self._repeated(whole, each)
                used = agents.stop - begin
                for row, result in zip(out, self._results, strict=True):
                    row[agents] = result[:used] if result.ndim else result
        return whole

    def _begin(self, state: Floats, walks: Floats, agents: slice) -> None:
        """Put in what is known of some agents; what is beyond the last is like it."""
        self._recording.agents, program = agents, self._program
        first = self._first[agents]
        _fill(self._lines.first, first)
        _fill(self._value_cells, first + program.shift[agents])
        constants = [program.columns[number] for number in self._filled]
        for row, column in zip(self._rows, (*state, *constants), strict=True):
            _fill(row, column[agents])
        if self._walks is not None:
            _fill(self._walks, walks[agents])

    def _repeated(self, times: int, each: int) -> int:
        for time in range(times):
            self._recording.next = each * time
            try:
                for call in self._calls:
                    call()
            except _EndedError:
                return time
        return times

    def _add(self, one: RegisterInstruction, memory: Registers, calls: list[Call]) -> None:
        """The calls of what is no arithmetic."""
        takes = [memory.number(register, calls) for register in one.takes]
        if one.operation == do.RECORD:
            calls.append(partial(self._recording.record, takes))
        elif one.operation == do.FINITE:
            calls.append(partial(_check, takes[0], np.zeros(memory.count)))
        elif one.operation == do.VALUE_OF_CELL:
            cells, at = memory.spare("cells"), memory.spare("at")
            calls += [
                into(at, np.add, takes[0], self._value_cells),
                partial(np.copyto, cells, at, casting="unsafe"),
            ]
            out = memory.for_number(one.gives[0])
            calls.append(partial(self._program.cells.take, cells, out=out, mode="clip"))
        elif one.operation == do.FRAME:
            rows = [
                None if register == NOWHERE else memory.for_number(register)
                for register in one.gives
            ]
            frame_calls(takes, rows, memory, self._lines, calls)
        else:
            self._move(one, takes, memory, calls)

    def _move(
        self, one: RegisterInstruction, takes: Sequence[Any], memory: Registers, calls: list[Call]
    ) -> None:
        state = [memory.for_number(register) for register in one.gives]
        found: list[Call] = [
            partial(np.copyto, row, before)
            for row, before in zip(state, takes, strict=False)
            if row is not before
        ]
        columns = [*state, *takes[len(state) :]]
        begin, each = step_calls(columns, self._walks, self._lines, self._dt)
        found += [*begin, *each * one.more]
        if self._walks is None and one.more >= FEWEST:
            found = [FreeSteps(takes, state, found, self._lines, one.more, self._dt)]
        calls += found


def _fill(row: Any, column: Any) -> None:
    row[: len(column)], row[len(column) :] = column, column[-1]


def _check(row: Any, zeros: Floats) -> None:
    if not math.isfinite(zeros.dot(row) if row.ndim else row):  # 0 times infinity is NaN
        raise _EndedError
