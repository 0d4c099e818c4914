"""A computation of columns over agents as a list of instructions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any

import numpy as np

from ...geometry.arrays import Floats, Integers
from . import operations
from .guarding import Instruction, guarded
from .numpy_loops import loop_of


class NotElementwiseError(TypeError):
    """A computation is not made of numbers of one agent alone, or looks at them to decide on how
    to go on: it cannot be written down."""


@dataclass
class Tape:
    """Values are numbered: first the columns that are given, then whatever is computed. A value
    that is there already is not computed again."""

    agents: int
    given: int
    """columns that the computation begins with"""
    instructions: list[Instruction] = field(default_factory=list)
    columns: dict[int, Floats] = field(default_factory=dict)
    """(N,) by value: constant columns"""
    numbers: dict[int, float] = field(default_factory=dict)
    """by value: numbers that all agents share"""
    functions: list[np.ufunc] = field(default_factory=list)
    """of numpy, that `CALL_ONE` and `CALL_TWO` call"""
    cells: Floats | None = None
    """a column of the cells of lines, and where the table of each agent begins in it"""
    shift: Integers | None = None
    takes_every_way: bool = True
    """whether code may ask if any agent is concerned, and gets the answer that some are"""
    _version: int = -1
    _count: int = -1
    _known: dict[Any, Any] = field(default_factory=dict)
    _kept: list[Any] = field(default_factory=list)
    """arrays whose addresses are keys"""

    def __post_init__(self) -> None:
        self._count = self.given

    def value(self, what: Any) -> int:
        """The value of a constant: an array (N,) or a number. Raises NotElementwiseError."""
        if isinstance(what, np.ndarray) and what.ndim:
            return self._column(what)
        if not isinstance(what, bool | int | float | np.generic | np.ndarray):
            raise NotElementwiseError(f"a {type(what).__name__} in a computation of columns")
        number = float(what)
        key = "number", np.float64(number).tobytes()
        if key not in self._known:
            self._known[key] = self._new()
            self.numbers[self._known[key]] = number
        found: int = self._known[key]
        return found

    def _column(self, array: Any) -> int:
        if array.shape != (self.agents,) or array.dtype.kind not in "fiub":
            raise NotElementwiseError(f"an array {array.shape} of {array.dtype} among columns")
        address = array.__array_interface__["data"][0]
        key = "column", address, array.strides, array.dtype.str
        if key not in self._known:
            self._kept.append(array)
            self._known[key] = self._new()
            self.columns[self._known[key]] = array.astype(np.float64)
        found: int = self._known[key]
        return found

    def put(self, operation: int, takes: Sequence[int], gives: int = 1, more: int = 0) -> Any:
        """The numbers of the values that an instruction gives, of one alone without a tuple."""
        key = operation, tuple(takes), more
        is_known = key in self._known
        if not is_known or not gives:
            found = tuple(self._new() for _ in range(gives))
            self.instructions.append((operation, tuple(takes), found, more))
            self._known[key] = found[0] if gives == 1 else found
        return self._known[key]

    def known(self, operation: int, takes: Sequence[int], more: int) -> tuple[int, ...]:
        """The values that such an instruction gives, if there is one already; else none."""
        found = self._known.get((operation, tuple(takes), more), ())
        return found if isinstance(found, tuple) else (found,)

    def function(self, called: np.ufunc) -> int:
        """The number of a function of numpy among those of the tape."""
        if called not in self.functions:
            self.functions.append(called)
        return self.functions.index(called)

    def look_up_in(self, cells: Floats, shift: Integers, version: int) -> None:
        """From now on `VALUE_OF_CELL` looks at this column of cells. `version`: how often it was
        changed. Raises NotElementwiseError where it looked at another before."""
        if self.cells is not None and self._version != version:
            raise NotElementwiseError("two columns of cells")
        self.cells, self.shift, self._version = cells, shift, version

    def _new(self) -> int:
        self._count += 1
        return self._count - 1


@dataclass(frozen=True)
class TapeProgram:
    """A tape in the form that it is carried out in. The rows of its registers are, in this
    order, the columns that are given, constant columns, constant numbers, and what is computed."""

    code: Integers
    """(I, 6) operation, three registers (or where the lists of them begin), a number, and the
    register of the result"""
    lists: Integers
    """registers of instructions that take or give many"""
    columns: Floats
    """(C, N)"""
    numbers: Floats
    gives: Integers
    """registers of what it all comes to; the first are the columns given, when it is repeated"""
    registers: int
    functions: tuple[np.ufunc, ...]
    cells: Floats
    shift: Integers
    """(N,)"""

    @property
    def arguments(self) -> tuple[Any, ...]:
        """What the compiled loop is called with."""
        loops = np.array([loop_of(one) for one in self.functions], dtype=np.int64)
        return (
            self.code, self.lists, self.columns, self.numbers, self.gives, self.registers,
            loops.reshape(-1, 2), self.cells, self.shift,
        )  # fmt: skip

    def take(self, agents: Integers) -> TapeProgram:
        """The same computation of some of the agents."""
        columns = np.take(
            self.columns, agents, axis=1
        )  # in the order that the loop is compiled for
        return replace(self, columns=columns, shift=self.shift[agents])


def program_of(
    tape: Tape, gives: Sequence[int], begins: Sequence[int] | None = None,
    instructions: Sequence[Instruction] | None = None,
) -> TapeProgram:  # fmt: skip
    """`gives`: the values that it comes to; `begins`: those that it begins with, if they are not
    the given ones; `instructions`: its own, if they are not all. Raises NotElementwiseError."""
    constants = *tape.columns, *tape.numbers
    given = tuple(range(tape.given) if begins is None else begins)
    own = tuple(tape.instructions if instructions is None else instructions)
    form = _form_of(given, constants, own, tuple(gives))
    nothing = np.zeros(0)
    return TapeProgram(
        code=form.code,
        lists=form.lists,
        columns=np.array([*tape.columns.values()]).reshape(-1, tape.agents),
        numbers=np.array([*tape.numbers.values()], dtype=np.float64),
        gives=form.gives,
        registers=form.registers,
        functions=tuple(tape.functions),
        cells=nothing if tape.cells is None else tape.cells,
        shift=np.zeros(tape.agents, np.int64) if tape.shift is None else tape.shift,
    )


@dataclass(frozen=True)
class _Form:
    """What `TapeProgram` has of the instructions alone. The arrays are never written to; marked as
    read-only they would have another type, for which the loop would be compiled once more."""

    code: Integers
    lists: Integers
    gives: Integers
    registers: int


@lru_cache(maxsize=16)
def _form_of(
    given: tuple[int, ...],
    constants: tuple[int, ...],
    instructions: tuple[Instruction, ...],
    gives: tuple[int, ...],
) -> _Form:
    """Kept, as batch after batch of one scenario does the same. A register is used again once its
    value is not needed any more, but never for a result of the instruction that needs it last."""
    fixed = [*given, *constants]
    register = {value: place for place, value in enumerate(fixed)}
    needed = guarded(_needed(instructions, gives), gives)
    last = {value: len(needed) for value in gives}
    for place in range(len(needed) - 1, -1, -1):
        for value in needed[place][1]:
            last.setdefault(value, place)
    free: list[int] = []
    begins = {value: place for place, value in enumerate(given)}
    if any(begins.get(value, place) != place for place, value in enumerate(gives)):
        raise NotElementwiseError("a column becomes another that was given")
    count = len(fixed)
    code: list[tuple[int, ...]] = []
    lists: list[int] = []
    for place, (_, takes, results, _) in enumerate(needed):
        in_place = _in_place(needed[place], last, place, register, len(fixed))
        for value in results:
            if in_place is not None:
                register[value] = register[in_place]
            elif free:
                register[value] = free.pop()
            else:
                register[value], count = count, count + 1
        code.append(_row(needed[place], register, lists))
        ended = {value for value in takes if last[value] == place and register[value] >= len(fixed)}
        ended.discard(in_place)
        unused = {value for value in results if value not in last}
        free += [register[value] for value in (*ended, *unused)]
    return _Form(
        code=np.array(code, dtype=np.int64).reshape(-1, 6),
        lists=np.array(lists, dtype=np.int64),
        gives=np.array([register[value] for value in gives], dtype=np.int64),
        registers=count,
    )


_FEW = 3


def _row(one: Instruction, register: Mapping[int, int], lists: list[int]) -> tuple[int, ...]:
    """That of an instruction in `TapeProgram.code`; what it takes more is added to the lists."""
    operation, takes, results, more = one
    places = [register[value] for value in takes]
    if len(results) == 1 and len(takes) <= _FEW:
        return (operation, *(*places, 0, 0, 0)[:_FEW], more, register[results[0]])
    begin = len(lists)
    lists += [*places, *(register[value] for value in results)]
    return operation, begin, 0, 0, more, len(takes)


def _in_place(
    one: Instruction, last: Mapping[int, int], place: int, register: Mapping[int, int], fixed: int
) -> int | None:
    """What a choice takes where its condition is false, if nothing needs that any more: it is
    written over where the condition is true, and left as it is where the choice is left out."""
    operation, takes, _, _ = one
    if operation != operations.WHERE or takes[2] in takes[:2]:
        return None
    ends = last[takes[2]] == place and register[takes[2]] >= fixed
    return takes[2] if ends else None


def _needed(instructions: Sequence[Instruction], gives: Sequence[int]) -> list[Instruction]:
    """The instructions on which something depends."""
    used, found = set(gives), []
    for instruction in reversed(instructions):
        operation, takes, results, _ = instruction
        if operation in _EFFECTS or not used.isdisjoint(results):
            used.update(takes)
            found.append(instruction)
    return found[::-1]


_EFFECTS = (operations.RECORD, operations.FINITE, operations.LIMITS, operations.WATCH)
