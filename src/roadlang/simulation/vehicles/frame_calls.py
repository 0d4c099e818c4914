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

_ON_ARC = 3
"""How many numbers `on_arc` gives."""


@cache
def arc_program(needed: tuple[bool, ...]) -> TapeProgram:
    """What is `needed` of `on_arc`, which begins with the columns of cells, the distance from where
    they begin, and their lengths."""
    tape = Tape(1, len(CELL) + 2)
    *cell, rest, spacing = (TracedColumn(tape, number) for number in range(tape.given))
    found = zip(on_arc(cell, rest, spacing), needed, strict=True)
    return program_of(tape, [value_of(tape, one) for one, is_needed in found if is_needed])


def frame_calls(
    takes: Sequence[Any], rows: Sequence[Floats | None], memory: Registers, lines: TableRows,
    calls: list[Call],
) -> None:  # fmt: skip
    """Add the calls that fill five rows as `poses.line_frames` does, but for those that are None,
    which nothing needs. `takes`: as of `cell_calls`."""
    cells, rest = cell_calls(takes, memory, lines, calls)
    # Whole cells: to find one takes time, as each agent is at another place of the memory, and to
    # read more of it takes none.
    table = memory.spare("table")
    calls.append(partial(lines.table.take, cells, 0, table, "clip"))
    columns = [*table.T]
    program = arc_program(tuple(row is not None for row in rows[:_ON_ARC]))
    numbers = [*columns, rest, takes[3], *(np.array(one) for one in program.numbers)]
    inside = Registers(memory.count, dict(enumerate(numbers)))
    steps, gives = instructions_of(program, 0)
    results = [row for row in rows[:_ON_ARC] if row is not None]
    inside.put_results(gives, results)
    calls += calls_of(steps, program.functions, inside, lines)
    calls += inside.copies(gives, results)
    calls += [
        partial(np.copyto, row, column)
        for row, column in zip(rows[_ON_ARC:], columns[6:], strict=True)
        if row is not None
    ]
