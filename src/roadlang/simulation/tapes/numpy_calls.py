"""Programs as calls of numpy's functions, on arrays that are there already: nothing is allocated,
and one call follows the other. The bits are those of the formulas that were traced."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..lines.lines import CELL
from . import operations as do
from .instructions import RegisterInstruction
from .registers import Call, Registers, aligned

_FUNCTIONS = {number: getattr(np, name) for name, number in do.BY_NAME.items()}
_COMPARISONS = {do.LESS: np.less, do.LESS_EQUAL: np.less_equal}
_OF_TRUTHS = {do.AND: np.logical_and, do.OR: np.logical_or, do.NOT: np.logical_not}


@dataclass(frozen=True)
class TableRows:
    """Where agents are in the table of lines."""

    table: Floats
    """(C, K) of each cell, as `Lines` has it"""
    first: Floats
    """(N,) the first cells of their lines, as numbers"""

    @classmethod
    def of(cls, table: Floats, first: Integers) -> TableRows:
        """`first`: (N,) the first cells of the lines of agents."""
        cells = aligned(1, len(first))[0]
        cells[:] = first
        return cls(table, cells)

    @property
    def pairs(self) -> Any:
        """(C K / 2,) two columns of the table in one number, which takes half the time to look
        up."""
        return self.table.reshape(-1).view(np.complex128)


_ZERO = np.array(0.0)


OtherCalls = Callable[[RegisterInstruction, Registers, list[Call]], None]
"""Something that adds the calls of an instruction."""


def calls_of(
    instructions: Sequence[RegisterInstruction], functions: Sequence[np.ufunc], memory: Registers,
    lines: TableRows, others: OtherCalls | None = None,
) -> list[Call]:  # fmt: skip
    """The calls that carry out instructions, in their order. `others`: what adds those of the
    operations that are not here."""
    calls: list[Call] = []
    left = iter(instructions)
    for one in left:
        operation = one.operation
        if operation == do.SKIP:
            mask = memory.truth(one.takes[0], calls)
            inside = [next(left) for _ in range(one.more)]
            before = memory.before(one.takes[0], inside, calls)
            found = calls_of(inside, functions, memory, lines, others)
            calls.append(partial(_if_any, mask, found))
            memory.go_back(*before)
        elif operation in (do.CALL_ONE, do.CALL_TWO):
            _arithmetic(one, functions[one.more], memory, calls)
        elif operation in _FUNCTIONS:
            _arithmetic(one, _FUNCTIONS[operation], memory, calls)
        elif operation in _COMPARISONS:
            takes = [memory.number(register, calls) for register in one.takes]
            out = memory.for_truth(one.gives[0])
            calls.append(into(out, _COMPARISONS[operation], *takes))
        elif operation in _OF_TRUTHS:
            truths = [memory.truth(register, calls) for register in one.takes]
            out = memory.for_truth(one.gives[0])
            calls.append(into(out, _OF_TRUTHS[operation], *truths))
        elif operation == do.COPY:
            value = memory.number(one.takes[0], calls)
            calls.append(partial(np.copyto, memory.for_number(one.gives[0]), value))
        elif operation == do.WHERE:
            _choose(one, memory, calls)
        elif operation == do.BEND:
            _bend(one, memory, lines, calls)
        elif operation == do.CELL:
            _cell(one, memory, lines, calls)
        elif others is not None:
            others(one, memory, calls)
        else:
            raise NotImplementedError(f"operation {operation}")
    return calls


def into(out: Any, function: np.ufunc, *takes: Any) -> Call:
    """The call that puts what a function gives into a row."""
    if function in _WITH_NAMES:
        one, other = takes
        return lambda: function(one, other, out=out)  # less time than `partial` with a name
    return partial(function, *takes, out)  # takes less time than with the name


_WITH_NAMES = (np.minimum, np.maximum)
"""Functions of which numpy wants the row by its name."""


def _arithmetic(
    one: RegisterInstruction, function: np.ufunc, memory: Registers, calls: list[Call]
) -> None:
    takes = [memory.number(register, calls) for register in one.takes]
    if function in _WITH_NAMES:
        takes = [memory.as_row(number) for number in takes]
    out = memory.for_number(one.gives[0])
    if function is np.remainder and not takes[1].ndim:
        calls.append(partial(_remainder, takes[0], takes[1], out))
    else:
        calls.append(into(out, function, *takes))


def _remainder(row: Floats, divisor: Any, out: Floats) -> None:
    """The remainder of what is between 0 and the divisor is itself, and takes eight times as long
    to find."""
    if row.ndim and row[row.argmin()] > 0.0 and row[row.argmax()] < divisor:
        np.copyto(out, row)
    else:
        np.remainder(row, divisor, out)


def _choose(one: RegisterInstruction, memory: Registers, calls: list[Call]) -> None:
    condition, *either = one.takes
    where = memory.truth(condition, calls)
    if all(memory.is_truth(register) for register in either):
        yes, no = (memory.truth(register, calls) for register in either)
        out: Any = memory.for_truth(one.gives[0])
    else:
        yes, no = (memory.number(register, calls) for register in either)
        out = memory.for_number(one.gives[0])
    if no is not out:
        calls.append(partial(np.copyto, out, no))
    calls.append(partial(np.copyto, out, yes, where=where))


def _if_any(mask: Booleans, calls: Sequence[Call]) -> None:
    if np.count_nonzero(mask):
        for call in calls:
            call()


def cell_calls(
    takes: Sequence[Any], memory: Registers, lines: TableRows, calls: list[Call], parts: int = 1,
    rest: Any = None,
) -> tuple[Integers, Floats]:  # fmt: skip
    """(N,) the cells of the table in which agents are, `parts` for each cell, and how far from
    where they begin; after calls that find it. `takes`: arc lengths, and of lines the last cell,
    the origin, the spacing, and cells for each meter. `rest`: the row for how far it is, if any is
    given."""
    along, last, origin, spacing, per_meter = takes
    rest = memory.spare("rest") if rest is None else rest
    cell, at = memory.spare("cell"), memory.spare("at")
    cells = memory.spare("cells")
    calls += [
        into(rest, np.subtract, along, origin),
        into(cell, np.multiply, rest, per_meter),
        into(cell, np.maximum, cell, memory.as_row(_ZERO)),
        into(cell, np.minimum, cell, last),
        into(cell, np.floor, cell),
        into(at, np.add, cell, lines.first),
        *([into(at, np.multiply, at, np.array(float(parts)))] if parts > 1 else []),
        partial(np.copyto, cells, at, casting="unsafe"),
        into(at, np.multiply, cell, spacing),
        into(rest, np.subtract, rest, at),
    ]
    return cells, rest


def bend_calls(
    takes: Sequence[Any], memory: Registers, lines: TableRows, calls: list[Call]
) -> tuple[Any, Any, Floats]:
    """(N,) curvature and heading of the cells in which agents are, and how far from where they
    begin; after calls that find it."""
    cells, rest = cell_calls(takes, memory, lines, calls, parts=lines.table.shape[1] // 2)
    pairs = memory.spare("pairs")
    begin = _BEND // 2
    calls.append(partial(lines.pairs[begin:].take, cells, out=pairs, mode="clip"))
    return pairs.real, pairs.imag, rest


_BEND = CELL.index("curvature")
"""The column of the curvature; the next is the heading."""


def _bend(one: RegisterInstruction, memory: Registers, lines: TableRows, calls: list[Call]) -> None:
    takes = [memory.number(register, calls) for register in one.takes]
    there, ahead, rest = bend_calls(takes, memory, lines, calls)
    curvature, heading = (memory.for_number(register) for register in one.gives)
    calls += [
        partial(np.copyto, curvature, there),
        into(heading, np.multiply, curvature, rest),
        into(heading, np.add, ahead, heading),
    ]


def _cell(one: RegisterInstruction, memory: Registers, lines: TableRows, calls: list[Call]) -> None:
    takes = [memory.number(register, calls) for register in one.takes]
    rest, *columns = (memory.for_number(register) for register in one.gives)
    begins, _ = cell_calls(takes, memory, lines, calls, lines.table.shape[1], rest)
    numbers = lines.table.reshape(-1)
    calls += [
        partial(numbers[place:].take, begins, out=column, mode="clip")
        for place, column in enumerate(columns)
    ]
