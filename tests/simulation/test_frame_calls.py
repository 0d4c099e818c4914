"""What is looked up of lines, by calls of numpy: what nothing needs is left out, and no bit of the
rest changes."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.simulation.lines.line_sources import LineSource
from roadlang.simulation.lines.lines import Lines
from roadlang.simulation.tapes import operations as do
from roadlang.simulation.tapes.instructions import NOWHERE, RegisterInstruction, without_unused
from roadlang.simulation.tapes.numpy_calls import TableRows
from roadlang.simulation.tapes.registers import Call, Registers, aligned
from roadlang.simulation.vehicles.frame_calls import frame_calls
from roadlang.simulation.vehicles.free_steps import LATER, FreeSteps
from roadlang.simulation.vehicles.motion import Track
from roadlang.simulation.vehicles.poses import frames_in

from .test_free_steps import DT, STEPS, Agents

_TURN = np.linspace(0.0, 1.5, 90)
_ARC = LineSource(50.0 * _TURN, 50.0 * np.sin(_TURN), 50.0 - 50.0 * np.cos(_TURN), _TURN, 7.0)
_STRAIGHT = LineSource(_TURN, _TURN, 0.0 * _TURN, 0.0 * _TURN, _TURN + 5.0)


@given(st.lists(st.booleans(), min_size=5, max_size=5), st.integers(0, 2**32 - 1))
def test_rows_that_are_needed_are_those_of_the_lines(needed: list[bool], seed: int) -> None:
    row = np.array([0, 1, 0, 1, 0])
    track = Track.of(Lines.of([_ARC, _STRAIGHT], 0.0), row)
    along = np.random.default_rng(seed).uniform(-3.0, 80.0, len(row))
    rows = [aligned(1, len(row))[0] if one else None for one in needed]
    calls: list[Call] = []
    takes: list[Any] = [along, track.last, track.origin, track.spacing, track.per_meter]
    lines = TableRows.of(track.lines.table, track.first)
    frame_calls(takes, rows, Registers(len(row), {}), lines, calls)
    for call in calls:
        call()
    expected = frames_in(track, *track.cell(along))
    for found, column in zip(rows, expected, strict=True):
        assert found is None or found.tobytes() == column.tobytes()


def _frame(*gives: int) -> RegisterInstruction:
    return RegisterInstruction(do.FRAME, (0, 1, 2, 3, 4), gives, 0)


def test_results_that_are_written_over_before_they_are_read_go_nowhere() -> None:
    over = RegisterInstruction(do.ADD, (9, 10), (11,), 0)
    found = without_unused([_frame(9, 10, 11, 12, 13), over], [11, 13])
    assert found == [_frame(9, 10, NOWHERE, NOWHERE, 13), over]


def test_what_is_written_over_of_some_agents_at_some_times_is_needed_by_the_others() -> None:
    skip = RegisterInstruction(do.SKIP, (5,), (), 1)
    chosen = RegisterInstruction(do.WHERE, (5, 9, 10), (10,), 0)
    written = RegisterInstruction(do.ADD, (9, 9), (11,), 0)
    found = without_unused([_frame(9, 10, 11, 12, 13), skip, chosen], [10])
    assert found[0] == _frame(9, 10, NOWHERE, NOWHERE, NOWHERE)
    found = without_unused([_frame(9, 10, 11, 12, 13), skip, written], [11])
    assert found[0] == _frame(9, NOWHERE, 11, NOWHERE, NOWHERE)


@pytest.mark.parametrize("in_place", [False, True])
def test_what_steps_begin_with_is_there_for_those_with_limits(in_place: bool) -> None:
    """They are begun again from there where an agent comes near a limit in the last steps."""
    motion = np.zeros((10, 3))
    motion[0], motion[2], motion[5], motion[9] = 4.0, 3.65, 1.0, -5.0  # slow after four steps
    agents = Agents(motion, np.array([np.zeros(3), np.full(3, -5.0)]), 0.9)
    begin = aligned(10, 3)
    begin[:] = motion
    into = list(begin) if in_place else list(aligned(10, 3))
    seen: list[bytes] = []
    columns = [
        *begin, *agents.bodies.in_order, *agents.wanted, *agents.track.places,
    ]  # fmt: skip
    with_limits = [lambda: seen.append(begin.tobytes())]
    lines = TableRows.of(agents.track.lines.table, agents.track.first)
    steps = FreeSteps(columns, into, with_limits, lines, STEPS, DT)
    before = begin.tobytes()
    steps()
    assert seen == [before]
    assert steps._wait == LATER
