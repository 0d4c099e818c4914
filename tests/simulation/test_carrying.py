"""What a tape has computed at its end is not computed again at its begin."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang.geometry.arrays import Floats
from roadlang.simulation.tapes import carrying
from roadlang.simulation.tapes.carrying import RepeatedProgram, repeated_program
from roadlang.simulation.tapes.numpy_tapes import NumpyTape
from roadlang.simulation.tapes.tape import Tape
from roadlang.simulation.tapes.traced import TracedColumn, value_of

AGENTS = 4
LINES = np.zeros((1, 8)), np.zeros(AGENTS, np.int64)


def waves(looks_at_end: bool) -> RepeatedProgram:
    """Two columns, of which the second grows by the sine of the first; asked for the sine of the
    first at the end too, if `looks_at_end`, as a recorder would."""
    tape = Tape(AGENTS, 2)
    step = np.linspace(0.1, 0.7, AGENTS)
    at, total = (TracedColumn(tape, number) for number in range(2))
    total = total + np.sin(at) * np.sqrt(step)
    at = at + step
    gives: list[Any] = [at, total, np.sin(at) if looks_at_end else at * 2.0]
    return repeated_program(tape, [value_of(tape, column) for column in gives])


def carried_out(program: RepeatedProgram, times: int) -> Floats:
    state = np.arange(2.0 * AGENTS).reshape(2, AGENTS)
    nothing, samples = np.zeros(AGENTS), np.empty((0, 1, AGENTS))
    begin = np.empty((len(program.first.gives), AGENTS))
    NumpyTape(program.first, 2, LINES, False, 0.02).repeated(state, nothing, 1, samples, begin)
    out = np.empty((len(program.each.gives), AGENTS))
    each = NumpyTape(program.each, len(begin), LINES, False, 0.02)
    each.repeated(begin, nothing, times, samples, out)
    return np.concatenate([out[:2], out[-1:]])


def test_what_is_computed_at_the_end_is_carried_over() -> None:
    program = waves(looks_at_end=True)
    assert len(program.first.code) == 1, "the sine"
    assert len(program.each.code) == 4
    assert len(waves(looks_at_end=False).first.code) == 0


@pytest.mark.parametrize("looks_at_end", [True, False])
def test_it_comes_to_the_same_bytes(looks_at_end: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    found = carried_out(waves(looks_at_end), 5)

    def nothing_moves(tape: Tape, ends: Any) -> Any:
        return [], {value: value for value in tape.columns} | dict(enumerate(ends))

    monkeypatch.setattr(carrying, "_moved", nothing_moves)
    assert carried_out(waves(looks_at_end), 5).tobytes() == found.tobytes()


def test_a_value_that_would_become_another_is_computed_each_time() -> None:
    tape = Tape(AGENTS, 2)
    at, other = (TracedColumn(tape, number) for number in range(2))
    first, second = np.sin(at), np.sin(other + 0.0 * at)
    gives = [other + 0.0 * at, at + first + second, first]
    program = repeated_program(tape, [value_of(tape, column) for column in gives])
    assert len(program.first.code) == 0
