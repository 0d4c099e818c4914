"""Steps of the vehicles with numpy: the formulas, written down once and carried out on rows of
memory that stay where they are."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, partial
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..tapes import operations as do
from ..tapes.instructions import instructions_of
from ..tapes.numpy_calls import TableRows, bend_calls, calls_of
from ..tapes.registers import Call, Registers, aligned
from ..tapes.tape import Tape, TapeProgram, program_of
from ..tapes.traced import TracedColumn, value_of
from .vehicle_dynamics import driven, moved, steered, turned, walked

MOTION, CAR, WANTED, LINE = 10, 13, 2, 4
"""Columns of the motion (in the order of `Motion`), of what agents are, of what they are to do, and
of their lines (last cell, origin, spacing, cells for each meter)."""
STATE = MOTION + 1
"""Columns that change: the motion, and the curvature of the line below the agent."""
COLUMNS = STATE + CAR + WANTED + LINE
MOST = 2048
"""Agents whose rows of memory stay in the caches from one call of the engine to the next, at most:
of more of them, new arrays are faster."""


@cache
def step_program(dt: float, walks: bool) -> TapeProgram:
    """One step, which begins with `COLUMNS` columns and who walks, as numbers. `walks`: whether
    anybody may."""
    tape = Tape(1, COLUMNS + 1)
    columns: Any = [TracedColumn(tape, number) for number in range(COLUMNS)]
    on_foot = TracedColumn(tape, COLUMNS, is_truth=True) if walks else None
    state, car, wanted, line = _parts(columns)

    def bend(along: Any) -> tuple[Any, Any]:
        takes = [value_of(tape, column) for column in (along, *line)]
        curvature, heading = tape.put(do.BEND, takes, gives=2)
        return TracedColumn(tape, curvature), TracedColumn(tape, heading)

    after = _stepped(state, car, wanted, on_foot, bend, dt)
    return program_of(tape, [value_of(tape, column) for column in after])


def _parts(columns: Sequence[Any]) -> tuple[Sequence[Any], ...]:
    """The columns of the state, of what agents are, of what they are to do, and of their lines."""
    to_do = STATE + CAR
    lines = to_do + WANTED
    return columns[:STATE], columns[STATE:to_do], columns[to_do:lines], columns[lines:]


def _stepped(
    state: Sequence[Any], car: Sequence[Any], wanted: Sequence[Any], walks: Any,
    bend: Callable[[Any], tuple[Any, Any]], dt: float,
) -> tuple[Any, ...]:  # fmt: skip
    """The state after a step. `walks`: who is on foot, None for nobody; `bend`: curvature and
    heading of lines at arc lengths."""
    along, offset, *motion, cosine, sine, tangent, line_heading, before, curve = state
    tangent = steered(tangent, wanted[0], car[11], car[12])
    after = driven(motion, tangent, before, wanted[1], car[:11], dt)
    if walks is not None:
        on_foot = walked(motion, tangent, wanted[1], car[0], dt)
        after = tuple(np.where(walks, *pair) for pair in zip(on_foot, after, strict=True))
    speeds = (motion[0], after[0], after[1])
    along, offset = moved((along, offset), speeds, (cosine, sine), curve, dt)
    curve, heading = bend(along)
    angle = after[2] * dt - (heading - line_heading)
    cosine, sine = turned(cosine, sine, angle)
    return along, offset, *after[:3], cosine, sine, tangent, heading, after[3], curve


def columns_after(
    motion: Sequence[Floats], car: Sequence[Floats], wanted: Sequence[Floats],
    walks: Booleans | None, bend: Callable[[Any], tuple[Any, Any]], steps: int, dt: float,
) -> Sequence[Floats]:  # fmt: skip
    """The motion (10) after some steps, by the formulas as they are. `walks`: who is on foot, None
    for nobody; `bend`: curvature and heading of lines at arc lengths."""
    state: Sequence[Floats] = (*motion, bend(motion[0])[0])
    for _ in range(steps):
        state = _stepped(state, car, wanted, walks, bend, dt)
    return state[:MOTION]


def step_calls(
    columns: Sequence[Any], walks: Floats | None, lines: TableRows, dt: float
) -> tuple[list[Call], list[Call]]:
    """The calls before the first step, and those of each step, which change the motion: the first
    of the `columns`, which are `COLUMNS` without the curvature. `walks`: who does, as numbers, None
    for nobody."""
    count = len(columns[0])
    curvature = aligned(1, count)[0]
    rows = [*columns[:MOTION], curvature, *columns[MOTION:], curvature if walks is None else walks]
    program = step_program(dt, walks is not None)
    numbers = [np.array(one) for one in program.numbers]
    memory = Registers(count, dict(enumerate([*rows, *numbers])))
    begin: list[Call] = []
    bend, _, _ = bend_calls((rows[0], *_parts(rows[:COLUMNS])[3]), memory, lines, begin)
    begin.append(partial(np.copyto, curvature, bend))
    steps, gives = instructions_of(program, STATE)
    calls = calls_of(steps, program.functions, memory, lines)
    calls += [
        partial(np.copyto, rows[place], memory.number(register, calls))
        for place, register in enumerate(gives)
        if place != register
    ]
    return begin, calls


class VehicleSteps:
    """Steps of some agents that follow their lines."""

    def __init__(
        self, table: Floats, first: Integers, places: Floats, walks: Booleans, dt: float
    ) -> None:
        """`table`: of the lines; `first`: (N,) where those of agents begin in it; `places`: (4, N)
        what else is to be known of them."""
        self._rows = aligned(COLUMNS - 1, len(first))
        self._rows[COLUMNS - 1 - LINE :] = places
        walkers = walks.astype(np.float64) if walks.any() else None
        lines = TableRows.of(table, first)
        self._begin, self._calls = step_calls(list(self._rows), walkers, lines, dt)
        self._car: Any = None

    def drive(
        self, motion: Sequence[Floats], car: Any, wanted: Sequence[Floats], steps: int
    ) -> Floats:
        """(10, N) the motion after some steps. `car`: the bodies of the agents."""
        rows = self._rows
        for row, column in enumerate(motion):
            rows[row] = column
        if car is not self._car:
            for row, column in enumerate(car.in_order, MOTION):
                rows[row] = column
            self._car = car
        for row, column in enumerate(wanted, MOTION + CAR):
            rows[row] = column
        with np.errstate(all="ignore"):
            for call in self._begin:
                call()
            for _ in range(steps):
                for call in self._calls:
                    call()
        out = aligned(MOTION, rows.shape[1])
        out[:] = rows[:MOTION]
        return out
