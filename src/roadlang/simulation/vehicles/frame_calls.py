"""Where lines are at arc lengths, by calls of numpy on rows of memory."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache, partial
from typing import Any

import numpy as np

from ...geometry.arrays import Floats
from ..lines.lines import CELL, on_arc
from ..tapes.instructions import instructions_of
from ..tapes.numpy_calls import TableRows, calls_of, cell_calls
from ..tapes.registers import Call, Registers
from ..tapes.tape import Tape, TapeProgram, program_of
from ..tapes.traced import TracedColumn, value_of


@cache
def arc_program() -> TapeProgram:
    """`on_arc`, which begins with the columns of cells, the distance from where they begin, and
    their lengths."""
    tape = Tape(1, len(CELL) + 2)
    *cell, rest, spacing = (TracedColumn(tape, number) for number in range(tape.given))
    return program_of(tape, [value_of(tape, one) for one in on_arc(cell, rest, spacing)])


def frame_calls(
    takes: Sequence[Any], rows: Sequence[Floats], memory: Registers, lines: TableRows,
    calls: list[Call],
) -> None:  # fmt: skip
    """Add the calls that fill five rows as `poses.line_frames` does. `takes`: as of
    `cell_calls`."""
    width = len(CELL) // 2
    cells, rest = cell_calls(takes, memory, lines, calls, parts=width)
    pairs = [memory.spare(f"pairs {place}") for place in range(width)]
    columns = [half for pair in pairs for half in (pair.real, pair.imag)]
    numbers = [*columns, rest, takes[3], *(np.array(one) for one in arc_program().numbers)]
    inside = Registers(memory.count, dict(enumerate(numbers)))
    steps, gives = instructions_of(arc_program(), 0)
    calls += [
        *(
            partial(lines.pairs[place:].take, cells, out=pair, mode="clip")
            for place, pair in enumerate(pairs)
        ),
        *calls_of(steps, arc_program().functions, inside, lines),
    ]
    calls += [
        partial(np.copyto, row, column)
        for row, column in zip(
            rows, (*(inside.number(one, calls) for one in gives), *columns[6:]), strict=True
        )
    ]
