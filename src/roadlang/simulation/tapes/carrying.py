"""What a tape begins with and has computed at its end before, such as where agents are: it is
carried over from one time to the next, and not computed twice."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ...geometry.arrays import Integers
from . import operations as do
from .guarding import Instruction
from .tape import Tape, TapeProgram, program_of

_NEVER = (
    do.LESS, do.LESS_EQUAL, do.AND, do.OR, do.NOT, do.MOVE, do.RECORD, do.FINITE,
)  # fmt: skip
"""Operations that stay where they are: those that give truth values, and those that are done once
each time."""


@dataclass(frozen=True)
class RepeatedProgram:
    """A tape that is repeated, in two parts."""

    first: TapeProgram
    """once, before the first time: from the columns that are given to these and those carried"""
    each: TapeProgram
    """each time: from all of them to the same, and to what else the tape comes to"""

    def take(self, agents: Integers) -> RepeatedProgram:
        """The same computation of some of the agents."""
        return RepeatedProgram(self.first.take(agents), self.each.take(agents))


def repeated_program(tape: Tape, gives: Sequence[int]) -> RepeatedProgram:
    """`gives`: the values that the tape comes to, the first of which it begins with when it is
    repeated. Raises NotElementwiseError."""
    given, ends, more = range(tape.given), gives[: tape.given], gives[tape.given :]
    moved, later = _moved(tape, ends)
    left = [one for one in tape.instructions if one not in moved]
    used = {value for _, takes, _, _ in left for value in takes} | {*gives}
    carried = [value for _, _, found, _ in moved for value in found]
    needed = used | {later[value] for value in carried if later[value] != value}
    carried = [value for value in carried if value in needed]
    results = {*gives, *(later[value] for value in carried if later[value] != value)}
    if not results.isdisjoint(carried):  # one would become another
        moved, left, carried = [], tape.instructions, []
    begins = *given, *carried
    return RepeatedProgram(
        program_of(tape, begins, instructions=moved),
        program_of(tape, [*ends, *(later[one] for one in carried), *more], begins, left),
    )


def _moved(tape: Tape, ends: Sequence[int]) -> tuple[list[Instruction], Mapping[int, int]]:
    """The instructions that are not needed after the first time, as the time before has what they
    give, and by value where that is found at the end. `ends`: of the columns that are given."""
    later = {value: value for value in (*tape.columns, *tape.numbers)} | dict(enumerate(ends))
    moved = []
    for one in tape.instructions:
        operation, takes, gives, more = one
        if operation not in _NEVER and all(value in later for value in takes):
            found = tape.known(operation, [later[value] for value in takes], more)
            if found:
                moved.append(one)
                later |= dict(zip(gives, found, strict=True))
    return moved, later
