"""What is written on a tape is computed to the same bits by the compiled loop as by numpy."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry.arrays import Floats
from roadlang.simulation.tapes import compiled_tapes
from roadlang.simulation.tapes.numpy_loops import loop_of
from roadlang.simulation.tapes.tape import NotElementwiseError, Tape, TapeProgram, program_of
from roadlang.simulation.tapes.traced import TracedColumn, value_of

from .traced_chains import ONE, STEPS, TWO, program_and_result

pytest.importorskip("numba")


def repeated(program: TapeProgram, columns: list[Floats], times: int) -> tuple[Any, int]:
    """What a program comes to, repeated some times, and how often it went to its end."""
    agents = len(columns[0])
    out, samples = np.empty((len(program.gives), agents)), np.empty((0, 1, agents))
    lines = np.zeros(agents, np.int64), np.zeros((1, 8)), np.zeros(agents)
    went = compiled_tapes.repeated()(
        np.stack(columns), program.arguments, lines, times, 0.02, samples, out
    )
    return out, int(went)


@given(STEPS, st.integers(1, 70), st.integers(0, 2**32 - 1))
def test_it_computes_what_numpy_does(steps: list[Any], agents: int, seed: int) -> None:
    program, columns, expected = program_and_result(steps, agents, seed, 3)
    found, went = repeated(program, columns, 3)
    assert went == 3
    assert found[3].tobytes() == expected[3].tobytes()
    assert found[0].tobytes() == expected[0].tobytes()


@pytest.mark.parametrize("name", [*ONE, *TWO])
def test_the_loops_are_those_of_numpy(name: str) -> None:
    assert loop_of(getattr(np, name)) is not None


@pytest.mark.parametrize(
    "look",
    [
        lambda one: bool(one > 1.0),
        lambda one: list(one),
        lambda one: np.asarray(one),
        lambda one: one[np.array([0])],
        lambda one: one.max(),
        lambda one: np.sum(one),
        lambda one: np.add.reduce(one),
        lambda one: one + np.zeros(3),
        lambda one: one + "m",
        lambda one: np.where(one, 1.0, 2.0),
        lambda one: (one > 1.0) + (one > 2.0),
        lambda one: np.frexp(one),
    ],
)
def test_what_looks_at_numbers_is_refused(look: Callable[[TracedColumn], Any]) -> None:
    with pytest.raises(NotElementwiseError):
        look(TracedColumn(Tape(5, 1), 0))


def test_a_value_that_is_there_is_not_computed_again() -> None:
    tape = Tape(2, 1)
    one: Any = TracedColumn(tape, 0)
    assert (np.sin(one) + 1.0).value == (np.sin(one) + 1.0).value
    assert len(tape.instructions) == 2


def test_a_program_of_some_agents_needs_no_other_compiled_loop() -> None:
    tape = Tape(4, 1)
    column = TracedColumn(tape, 0) + np.array([1.0, 2.0, 3.0, 4.0])
    some = program_of(tape, [0, value_of(tape, column)]).take(np.array([3, 1]))
    assert some.columns.flags.c_contiguous
    assert some.columns.tolist() == [[4.0, 2.0]]


def test_registers_are_chosen_once_for_the_same_instructions_of_other_numbers() -> None:
    programs = []
    for factor in (2.0, 3.0):
        tape = Tape(4, 1)
        column = TracedColumn(tape, 0) * factor + np.arange(4.0) * factor
        programs.append(program_of(tape, [0, value_of(tape, column)]))
    one, other = programs
    assert one.code is other.code
    assert (one.numbers.tolist(), other.numbers.tolist()) == ([2.0], [3.0])
    assert other.columns.tolist() == [[0.0, 3.0, 6.0, 9.0]]
