"""The paths ahead of agents as these see them, by calls of numpy on rows of memory."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache, partial
from typing import Any

import numpy as np

from ...geometry.arrays import Floats, Integers
from ..lines.lines import beside_chord
from ..tapes import operations as do
from ..tapes.instructions import instructions_of
from ..tapes.numpy_calls import TableRows, calls_of
from ..tapes.registers import Call, Registers, aligned
from ..tapes.tape import Tape, TapeProgram, program_of
from ..tapes.traced import TracedColumn, value_of

AGENT, LINE = 6, 4
"""Columns that change: arc length, how far left of the line the path is, x, y, cosine and sine of
the heading. Those of the lines: last cell, origin, spacing, cells for each meter."""
FEWEST = 256
"""Agents of which it takes less time than with new arrays, at least."""


def turned(x: Any, y: Any, axes: tuple[Any, Any]) -> tuple[Any, Any]:
    """Meters ahead and to the left, of meters east and north. `axes`: cosine and sine of the
    heading."""
    cosine, sine = axes
    return x * cosine + y * sine, y * cosine - x * sine


@cache
def path_program(distances: tuple[float, ...]) -> TapeProgram:
    """Meters ahead and to the left of the points of paths some distances on, (2 K): it begins with
    rows for them, and the columns `AGENT` and `LINE`."""
    tape = Tape(1, 2 * len(distances) + AGENT + LINE)
    columns: Any = [TracedColumn(tape, number) for number in range(tape.given)][-AGENT - LINE :]
    (along, left, x, y, *axes), line = columns[:AGENT], columns[AGENT:]
    found: list[Any] = []
    for distance in distances:
        takes = [value_of(tape, column) for column in (along + distance, *line)]
        rest, *cell = (TracedColumn(tape, value) for value in tape.put(do.CELL, takes, gives=6))
        point_x, point_y = beside_chord(cell, rest, line[2], left)
        found += turned(point_x - x, point_y - y, (axes[0], axes[1]))
    return program_of(tape, [value_of(tape, column) for column in found])


class PathRows:
    """Paths of agents along open lines."""

    def __init__(
        self, table: Floats, first: Integers, places: Floats, distances: Sequence[float]
    ) -> None:
        """`table`, `first` and `places`: as of `VehicleSteps`."""
        count, program = len(first), path_program(tuple(distances))
        self._found = 2 * len(distances)
        self._rows = aligned(self._found + AGENT + LINE, count)
        self._rows[-LINE:] = places
        numbers = [*self._rows, *(np.array(one) for one in program.numbers)]
        memory = Registers(count, dict(enumerate(numbers)))
        steps, gives = instructions_of(program, self._found)
        lines = TableRows.of(table, first)
        self._calls: list[Call] = calls_of(steps, program.functions, memory, lines)
        self._calls += [
            partial(np.copyto, self._rows[place], memory.number(register, self._calls))
            for place, register in enumerate(gives)
            if place != register
        ]

    def seen(self, columns: Sequence[Floats]) -> Floats:
        """(2 K, N) ahead and to the left by turns, of the columns `AGENT`. The same memory every
        time."""
        for row, column in zip(self._rows[self._found :], columns, strict=False):
            row[:] = column
        for call in self._calls:
            call()
        return self._rows[: self._found]
