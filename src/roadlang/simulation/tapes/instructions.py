"""The instructions of a program, one by one, with the registers that each takes and gives."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from . import operations as do
from .tape import TapeProgram

_LISTED: Mapping[int, int] = {
    do.FRAME: 5,
    do.MOVE: 10,
    do.RECORD: 0,
    do.FINITE: 0,
    do.SKIP: 0,
    do.BEND: 2,
    do.CELL: 6,
    do.LIMITS: 0,
    do.WATCH: 0,
}
"""Operations whose registers are in the lists of a program, and how many registers they give."""
_ARITHMETIC = {*range(do.LESS), do.CALL_ONE, do.CALL_TWO}
"""Operations whose result may take the place of what they take."""

NOWHERE = -1
"""In place of a register: of a result that nothing needs."""


@dataclass(frozen=True)
class RegisterInstruction:
    """One of a program, by registers."""

    operation: int
    takes: tuple[int, ...]
    gives: tuple[int, ...]
    more: int


def instructions_of(
    program: TapeProgram, given: int
) -> tuple[list[RegisterInstruction], list[int]]:
    """The instructions of a program with so many columns `given`, and the registers of what it
    comes to: those of the given ones in which it begins anew, where nothing needs what was in them
    before."""
    found = [_read(row, program.lists.tolist()) for row in program.code.tolist()]
    gives = program.gives.tolist()
    for register, result in enumerate(gives[:given]):
        place = _written_last(found, result)
        if result >= given and place >= 0 and _may_replace(found, place, register, result):
            found[place:] = [
                _with_register(one, result, register, number == 0)
                for number, one in enumerate(found[place:])
            ]
            gives = [register if one == result else one for one in gives]
    return found, gives


def without_unused(
    instructions: Sequence[RegisterInstruction], gives: Sequence[int]
) -> list[RegisterInstruction]:
    """The same, where what is looked up of lines (`FRAME`) goes `NOWHERE` if nothing needs it."""
    out, needed = list(instructions), {*gives}
    may_be_left_out = {
        place + 1 + inside
        for place, one in enumerate(out)
        if one.operation == do.SKIP
        for inside in range(one.more)
    }
    for place in range(len(out) - 1, -1, -1):
        one = out[place]
        if one.operation == do.FRAME:
            used = (register if register in needed else NOWHERE for register in one.gives)
            out[place] = replace(one, gives=tuple(used))
        if place not in may_be_left_out:
            needed.difference_update(one.gives)
        needed.update(one.takes)
    return out


def _read(row: Sequence[int], lists: Sequence[int]) -> RegisterInstruction:
    operation, a, b, c, more, to = row
    if operation in _LISTED:
        end = a + to + _LISTED[operation]
        return RegisterInstruction(
            operation, tuple(lists[a : a + to]), tuple(lists[a + to : end]), more
        )
    return RegisterInstruction(operation, (a, b, c)[: _count(operation)], (to,), more)


def _count(operation: int) -> int:
    """How many registers an operation takes."""
    if operation == do.WHERE:
        return 3
    one = (
        do.NEGATIVE, do.ABSOLUTE, do.FLOOR, do.SQRT, do.NOT, do.COPY, do.CALL_ONE,
        do.VALUE_OF_CELL,
    )  # fmt: skip
    return 1 if operation in one else 2


def _written_last(instructions: Sequence[RegisterInstruction], register: int) -> int:
    places = [place for place, one in enumerate(instructions) if register in one.gives]
    return places[-1] if places else -1


def _may_replace(
    instructions: Sequence[RegisterInstruction], place: int, register: int, result: int
) -> bool:
    """Whether the result of the instruction at a place can be put into another register."""
    if any(register in (*one.takes, *one.gives) for one in instructions[place + 1 :]):
        return False
    one = instructions[place]
    if one.operation == do.MOVE:
        return [*one.takes, *one.gives].count(register) == 1 and (
            one.takes[one.gives.index(result)] == register
        )
    return one.operation in _ARITHMETIC


def _with_register(
    one: RegisterInstruction, old: int, new: int, is_first: bool
) -> RegisterInstruction:
    """An instruction with another register; of the first, only what it gives."""
    gives = tuple(new if register == old else register for register in one.gives)
    if is_first:
        return replace(one, gives=gives)
    takes = tuple(new if register == old else register for register in one.takes)
    return replace(one, takes=takes, gives=gives)
