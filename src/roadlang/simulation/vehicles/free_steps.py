"""Steps of vehicles that reach no limit: neither of the grip of their tires nor of their steering,
engine or brakes, and do not stop. The bits are those of the formulas with limits, but there are
fewer formulas, and which limits are near is asked for all agents at once."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cache, partial
from typing import Any

import numpy as np

from ...geometry.arrays import Floats
from ..tapes import operations as do
from ..tapes.instructions import RegisterInstruction, instructions_of
from ..tapes.numpy_calls import TableRows, calls_of
from ..tapes.registers import Call, Registers
from ..tapes.tape import Tape, TapeProgram, program_of
from ..tapes.traced import TracedColumn, value_of
from . import vehicle_dynamics as dynamics

MOTION, CAR, WANTED, LINE = 10, 13, 2, 4
"""Columns of the motion (in the order of `Motion`), of what agents are, of what they are to do, and
of their lines (last cell, origin, spacing, cells for each meter)."""
COLUMNS = MOTION + CAR + WANTED + LINE
SHARE = 0.99
"""Of the squared grip of an axle that may be used: brakes, engine and bends together."""
NEARLY = 0.999
"""Share of other limits that may be reached: beside them, rounding is nothing."""
FEWEST = 3
"""Steps for which it pays to ask."""
LATER = 8
"""Times that nobody asks again whether limits are far, once one was near."""
SPEED, SLIP, APPROACH, MOVED_LOAD = range(4)
"""What is watched: slips have no sign."""

_TINY = 1e-12


class NearLimitError(Exception):
    """An agent comes near a limit."""


@cache
def free_program(dt: float, steps: int) -> TapeProgram:
    """Some steps, which begin with `COLUMNS` columns."""
    tape = Tape(1, COLUMNS)
    columns: Any = [TracedColumn(tape, number) for number in range(COLUMNS)]
    state, car, wanted, line = (
        columns[begin : begin + count]
        for begin, count in (
            (0, MOTION), (MOTION, CAR), (MOTION + CAR, WANTED), (COLUMNS - LINE, LINE),
        )
    )  # fmt: skip

    def bend(along: Any) -> tuple[Any, Any]:
        takes = [value_of(tape, column) for column in (along, *line)]
        curvature, heading = tape.put(do.BEND, takes, gives=2)
        return TracedColumn(tape, curvature), TracedColumn(tape, heading)

    def watch(what: int, column: Any) -> None:
        tape.put(do.WATCH, [value_of(tape, column)], gives=0, more=what)

    used = wanted[1] / car[6]
    tape.put(do.LIMITS, [value_of(tape, one) for one in (used, wanted[1], *car)], gives=0)
    watch(SPEED, state[2])
    watch(APPROACH, dynamics.approach(state[7], wanted[0], car[11]))
    watch(MOVED_LOAD, car[7] * state[9])
    curve = bend(state[0])[0]
    for _ in range(steps):
        state, curve = _stepped((state, curve), car, (wanted[0], used), (bend, watch), dt)
    return program_of(tape, [value_of(tape, column) for column in state])


def _stepped(
    before: tuple[Sequence[Any], Any], car: Sequence[Any], wanted: tuple[Any, Any],
    asking: tuple[Callable[[Any], tuple[Any, Any]], Callable[[int, Any], None]], dt: float,
) -> tuple[Sequence[Any], Any]:  # fmt: skip
    """The motion after a step, and the curvature of lines there; of `before` it. `wanted`: tangent
    of the steering angle, and share of the grip; `asking`: curvature and heading of lines at arc
    lengths, and what is reported of columns that are watched."""
    (bend, watch), (state, curve) = asking, before
    along, offset, vx, vy, yaw_rate, cosine, sine, tangent, line_heading, acceleration = state
    half_base, friction, front_slope, rear_slope, slow, _, _, transfer, inertia = car[:9]
    tangent = tangent + dynamics.approach(tangent, wanted[0], car[11])
    load = dynamics.loads_after(transfer * acceleration)
    swing = half_base * yaw_rate
    side = vy + swing
    ahead = dynamics.greatest(vx + side * tangent, slow)  # to watch it takes more time
    front = (side - vx * tangent) / ahead * front_slope
    rear = (vy - swing) / vx * rear_slope
    watch(SLIP, np.abs(front))
    watch(SLIP, np.abs(rear))
    share = dynamics.brush_share(front), dynamics.brush_share(rear)
    grip = friction * load[0], friction * load[1]
    force = dynamics.axle_forces(tangent, wanted[1], share, grip)
    motion = (vx, vy, yaw_rate)
    after = dynamics.pushed(motion, force, half_base, inertia, (car[9], car[10]), dt)
    watch(SPEED, after[0])
    place, speeds = (along, offset), (vx, after[0], after[1])
    along, offset = dynamics.moved(place, speeds, (cosine, sine), curve, dt)
    curve, heading = bend(along)
    angle = after[2] * dt - (heading - line_heading)
    cosine, sine = dynamics.turned(cosine, sine, angle)
    return (along, offset, *after[:3], cosine, sine, tangent, heading, after[3]), curve


@dataclass
class _Limits:
    """Between which numbers rows have to stay, by what is watched."""

    dt: float
    least: list[float] = field(default_factory=lambda: [0.0] * 4)
    most: list[float] = field(default_factory=lambda: [0.0] * 4)

    def look(self, columns: Sequence[Any]) -> None:
        """Between which numbers columns must stay, of the share of grip that is used, what
        acceleration is wanted, and what agents are."""
        used, wanted, *car = columns
        slow, transfer, drag, rolling = (_most(car[place]) for place in (4, 7, 9, 10))
        brakes, engine = -_least(wanted), _most(wanted)
        squared = max(_most(used), -_least(used)) ** 2
        # What air may add to the forces of the tires until the load of an axle is all moved.
        air = NEARLY * dynamics.HALF / max(transfer, _TINY) - _most(car[6]) - rolling
        if not (squared < SHARE and air > 0.0 and _most(car[11]) <= 1.0):
            raise NearLimitError
        least, most = self.least, self.most
        most[SPEED] = math.sqrt(air / max(drag, _TINY))
        if engine > 0.0:
            most[SPEED] = min(most[SPEED], NEARLY * _least(car[5]) / engine)
        braked = max(brakes, rolling) * self.dt / NEARLY
        least[SPEED] = max(slow, dynamics.LEAST_POWER_SPEED, braked)
        most[SLIP] = 1.0 - (1.0 - math.sqrt(SHARE - squared)) ** (1.0 / 3.0)
        most[APPROACH] = NEARLY * _least(car[12])
        most[MOVED_LOAD] = NEARLY * dynamics.HALF
        for what in (APPROACH, MOVED_LOAD):
            least[what] = -most[what]

    def watch_least(self, row: Any, what: int) -> None:
        """Ask whether all of a row are far enough above."""
        if not _least(row) >= self.least[what]:
            raise NearLimitError

    def watch_most(self, row: Any, what: int) -> None:
        """Ask whether all of a row are far enough below."""
        if not _most(row) <= self.most[what]:
            raise NearLimitError


class FreeSteps:
    """The steps of some agents, with limits where one of them may come near one."""

    def __init__(
        self, columns: Sequence[Any], into: Sequence[Floats], with_limits: Sequence[Call],
        lines: TableRows, steps: int, dt: float,
    ) -> None:  # fmt: skip
        """`columns`: `COLUMNS`, before; `into`: (10,) rows for the motion after it, which
        `with_limits` fill too."""
        self._with_limits, self._wait = with_limits, 0
        # No call holds the steps themselves: their memory is free with their last user.
        self._limits = _Limits(dt)
        program = free_program(dt, steps)
        count = len(columns[0])
        numbers = [*columns, *(np.array(one) for one in program.numbers)]
        memory = Registers(count, dict(enumerate(numbers)))
        found, gives = instructions_of(program, 0)
        if not any(np.may_share_memory(row, column) for row in into for column in columns):
            memory.put_results(gives, into)  # else they are still needed where a limit is near
        self._calls = calls_of(found, program.functions, memory, lines, self._add)
        self._calls += memory.copies(gives, into)

    def __call__(self) -> None:
        """Make them."""
        if self._wait:
            self._wait -= 1
        else:
            try:
                for call in self._calls:
                    call()
                return
            except NearLimitError:
                self._wait = LATER
        for call in self._with_limits:
            call()

    def _add(self, one: RegisterInstruction, memory: Registers, calls: list[Call]) -> None:
        limits = self._limits
        takes = [memory.number(register, calls) for register in one.takes]
        if one.operation == do.LIMITS:
            calls.append(partial(limits.look, takes))
        else:
            if one.more != SLIP:
                calls.append(partial(limits.watch_least, takes[0], one.more))
            calls.append(partial(limits.watch_most, takes[0], one.more))


def _least(row: Any) -> float:
    """NaN where any is."""
    return float(row[row.argmin()] if row.ndim else row)  # takes half the time of `min`


def _most(row: Any) -> float:
    return float(row[row.argmax()] if row.ndim else row)
