"""Tapes leave out what concerns nobody; the numbers are the same."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang.simulation.tapes import compiled_tapes
from roadlang.simulation.tapes import operations as do
from roadlang.simulation.tapes.instructions import instructions_of
from roadlang.simulation.tapes.numpy_tapes import NumpyTape
from roadlang.simulation.tapes.tape import Tape, TapeProgram, program_of
from roadlang.simulation.tapes.traced import TracedColumn, value_of

LEAST = 2.0
OFFSETS = (0.0, 1.5, 5.0)
"""Nobody, some and all of the agents are beyond `LEAST`."""
COUNT = 6
LINES = np.zeros((1, 8)), np.zeros(COUNT, np.int64)


def after(place: Any, speed: Any) -> tuple[Any, Any]:
    """A step in which who is far along slows down and is put back."""
    is_far = place > LEAST
    twice = place * 2.0
    drag = np.sqrt(np.abs(twice - 1.0)) + speed * speed
    slower = np.where(is_far, speed - 0.01 * drag, speed)
    back = np.where(is_far, place - 3.0, place + slower)
    return back, slower


def program() -> TapeProgram:
    tape = Tape(COUNT, 2)
    found = after(TracedColumn(tape, 0), TracedColumn(tape, 1))
    return program_of(tape, [value_of(tape, one) for one in found])


def state(offset: float) -> Any:
    return np.array([np.linspace(0.0, 1.0, COUNT) + offset, np.linspace(-0.5, 0.5, COUNT)])


@pytest.mark.parametrize("offset", OFFSETS)
@pytest.mark.parametrize("with_numba", [False, True])
def test_the_numbers_are_the_same(offset: float, with_numba: bool) -> None:
    begin, out = state(offset), np.empty((2, COUNT))
    nothing, samples, times = np.zeros(COUNT), np.empty((0, 1, COUNT)), 9
    if with_numba:
        pytest.importorskip("numba")
        lines = LINES[1], LINES[0], nothing
        compiled_tapes.repeated()(begin, program().arguments, lines, times, 0.02, samples, out)
    else:
        NumpyTape(program(), 2, LINES, False, 0.02).repeated(begin, nothing, times, samples, out)
    expected: Any = tuple(begin)
    for _ in range(times):
        expected = after(*expected)
    assert out.tobytes() == np.array(expected).tobytes()


def test_what_only_some_need_is_left_out_together() -> None:
    found, _ = instructions_of(program(), 2)
    operations = [one.operation for one in found]
    begin = operations.index(do.SKIP)
    inside = operations[begin + 1 : begin + 1 + found[begin].more]
    assert {do.SQRT, do.ABSOLUTE} <= {*inside}
    assert do.ADD in operations[begin + 1 + len(inside) :], "all need it"
    assert inside[-1] == do.WHERE
    (choice,) = [one for one in found[begin:] if one.operation == do.WHERE][:1]
    assert choice.gives[0] == choice.takes[2], "as it is where nobody is far along"


def test_few_instructions_are_not_asked_about() -> None:
    tape = Tape(COUNT, 1)
    column = TracedColumn(tape, 0)
    chosen = np.where(column > LEAST, column - 1.0, column)
    few = program_of(tape, [value_of(tape, chosen)])
    assert do.SKIP not in few.code[:, 0].tolist()
