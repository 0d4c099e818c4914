"""The loop that carries out programs. numba compiles it; Python never runs it."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..lines import lines
from ..vehicles import kernels
from . import operations as do

ABREAST = kernels.ABREAST
MOST = 64
"""Agents of which the loop carries out one instruction after another, at most: with more of them,
what their instructions compute no longer fits into the fastest cache."""


def call_loop(address: Any, arguments: Any, count: Any, strides: Any, data: Any) -> None:
    """Call a loop of numpy; said where this is compiled."""


def repeated(
    state: Any, program: Any, lines_of: Any, times: Any, dt: Any, samples: Any, out: Any
) -> Any:
    """Carry out a program `times` times, from `state` (S, N), and fill `out` (O, N) with what it
    comes to, and `samples` (times K, Q, N). Returns how many times nothing was infinite or NaN that
    must not be. `program`: code, lists, columns, numbers, registers of results, how many registers,
    loops, cells, shift. `lines_of`: (N,) where the tables of the lines of agents begin, the table,
    and who walks, as numbers."""
    code, lists, columns, numbers, gives, registers, loops, cells, shift = program
    first, table, walks = lines_of
    given, count = state.shape
    blocks = max(1, (count + MOST - 1) // MOST)
    wide = (count + blocks - 1) // blocks
    r, walking = np.empty((registers, wide)), np.empty(wide)
    starts, shifts = np.empty(wide, np.int64), np.empty(wide, np.int64)
    called = np.empty(3, np.int64), np.empty(1, np.int64), np.empty(3, np.int64)
    called[1][0] = wide
    for k in range(3):
        called[2][k] = 8
    for k in range(numbers.shape[0]):
        for j in range(wide):
            r[given + columns.shape[0] + k, j] = numbers[k]
    text, where = (code, lists, loops, called), (starts, shifts, table, cells)
    each, whole = samples.shape[0] // times, times
    for begin in range(0, count, wide):
        used = min(wide, count - begin)
        for j in range(wide):  # what is beyond the last agent is like it
            i = begin + min(j, used - 1)
            starts[j], shifts[j], walking[j] = first[i], shift[i], walks[i]
            for k in range(given):
                r[k, j] = state[k, i]
            for k in range(columns.shape[0]):
                r[given + k, j] = columns[k, i]
        for time in range(whole):
            if not once(r, walking, text, where, dt, samples, (each * time, begin, used)):
                whole = min(whole, time)
                break
            for k in range(given):
                for j in range(wide):
                    r[k, j] = r[gives[k], j]
        for k in range(gives.shape[0]):
            for j in range(used):
                out[k, begin + j] = r[gives[k], j] if k >= given else r[k, j]
    return whole


def once(
    r: Any, walking: Any, text: Any, where: Any, dt: Any, samples: Any, place: Any
) -> Any:  # fmt: skip
    """Carry out a program once. Whether it came to its end. `place`: the number of its first
    sample, that of the first agent, and how many agents these are."""
    code, lists, loops, called = text
    starts, shifts, table, cells = where
    sample, begin, used = place
    number = -1
    while number + 1 < code.shape[0]:
        number += 1
        operation, a, b = code[number, 0], code[number, 1], code[number, 2]
        more, to = code[number, 4], code[number, 5]
        if operation == do.CALL_ONE or operation == do.CALL_TWO:
            call(r, (a, b, to, operation == do.CALL_TWO), loops[more, 0], loops[more, 1], called)
        elif operation == do.FRAME:
            frame(r, lists, a, starts, table)
        elif operation == do.VALUE_OF_CELL:
            for j in range(r.shape[1]):
                r[to, j] = cells[shifts[j] + starts[j] + int(r[a, j])]
        elif operation == do.COPY:
            for j in range(r.shape[1]):
                r[to, j] = r[a, j]
        elif operation == do.MOVE:
            move(r, lists, a, walking, starts, table, more, dt)
        elif operation == do.RECORD:
            for k in range(to):
                for j in range(used):
                    samples[sample, k, begin + j] = r[lists[a + k], j]
            sample += 1
        elif operation == do.FINITE:
            if not finite(r, lists[a]):
                return False
        elif operation == do.SKIP:
            if not concerns(r, lists[a]):
                number += more
        else:
            compute(r, operation, a, b, code[number, 3], to)
    return True


def call(r: Any, registers: Any, loop: Any, data: Any, called: Any) -> None:
    """Call a loop of numpy, of one register or of two."""
    arguments, count, strides = called
    a, b, to, takes_two = registers
    at, wide = r.ctypes.data, 8 * r.shape[1]
    arguments[0], arguments[2] = at + a * wide, at + to * wide
    arguments[1] = at + (b if takes_two else to) * wide
    call_loop(loop, arguments.ctypes.data, count.ctypes.data, strides.ctypes.data, data)


def compute(r: Any, operation: Any, a: Any, b: Any, c: Any, to: Any) -> None:
    """Arithmetic of registers `a`, `b` and `c`, into another."""
    if operation == do.ADD:
        for j in range(r.shape[1]):
            r[to, j] = r[a, j] + r[b, j]
    elif operation == do.SUBTRACT:
        for j in range(r.shape[1]):
            r[to, j] = r[a, j] - r[b, j]
    elif operation == do.MULTIPLY:
        for j in range(r.shape[1]):
            r[to, j] = r[a, j] * r[b, j]
    elif operation == do.DIVIDE:
        for j in range(r.shape[1]):
            r[to, j] = r[a, j] / r[b, j]
    elif operation == do.NEGATIVE:
        for j in range(r.shape[1]):
            r[to, j] = -r[a, j]
    elif operation == do.ABSOLUTE:
        for j in range(r.shape[1]):
            r[to, j] = abs(r[a, j])
    elif operation == do.FLOOR:
        for j in range(r.shape[1]):
            r[to, j] = np.floor(r[a, j])
    elif operation == do.SQRT:
        for j in range(r.shape[1]):
            r[to, j] = np.sqrt(r[a, j])
    elif operation == do.LESS:
        for j in range(r.shape[1]):
            r[to, j] = 1.0 if r[a, j] < r[b, j] else 0.0
    elif operation == do.LESS_EQUAL:
        for j in range(r.shape[1]):
            r[to, j] = 1.0 if r[a, j] <= r[b, j] else 0.0
    elif operation == do.AND:
        for j in range(r.shape[1]):
            r[to, j] = r[a, j] * r[b, j]
    elif operation == do.OR:
        for j in range(r.shape[1]):
            r[to, j] = 1.0 if r[a, j] + r[b, j] > 0.5 else 0.0
    elif operation == do.NOT:
        for j in range(r.shape[1]):
            r[to, j] = 1.0 - r[a, j]
    elif operation == do.WHERE:
        for j in range(r.shape[1]):
            r[to, j] = r[b, j] if r[a, j] > 0.5 else r[c, j]


def frame(r: Any, lists: Any, a: Any, starts: Any, table: Any) -> None:
    """Of arc lengths, and the lines of agents, what `kernels.framed` gives; the registers are those
    in `lists` from `a` on."""
    along, last, origin, spacing = lists[a], lists[a + 1], lists[a + 2], lists[a + 3]
    per_meter, x, y, heading = lists[a + 4], lists[a + 5], lists[a + 6], lists[a + 7]
    curvature, width = lists[a + 8], lists[a + 9]
    for j in range(r.shape[1]):
        advance, place = kernels.place_on_line(
            r[along, j], r[last, j], r[origin, j], r[per_meter, j]
        )
        cell = table[starts[j] + int(place)]
        rest = advance - int(place) * r[spacing, j]
        r[x, j], r[y, j], r[heading, j] = lines.on_arc(cell, rest, r[spacing, j])
        r[curvature, j], r[width, j] = cell[6], cell[7]


def move(
    r: Any, lists: Any, a: Any, walking: Any, starts: Any, table: Any, steps: Any, dt: Any
) -> None:  # fmt: skip
    """Some steps of the vehicles: of the ten columns of their motion, what they are (13), what they
    are to do (2) and their lines (4) the next ten columns of their motion."""
    wide = r.shape[1]
    # Made here and no argument: so the compiler knows how far apart the rows are, and computes
    # several agents at once.
    rows, first = np.empty((35, ABREAST)), np.empty(ABREAST, np.int64)
    for begin in range(0, wide, ABREAST):
        used = min(ABREAST, wide - begin)
        for k in range(29):  # one row after another: several numbers are copied at once
            row = lists[a + k]
            for j in range(used):
                rows[k, j] = r[row, begin + j]
            for j in range(used, ABREAST):  # what is beyond the last agent is like it
                rows[k, j] = rows[k, used - 1]
        for j in range(ABREAST):
            i = begin + min(j, used - 1)
            first[j], rows[34, j] = starts[i], walking[i]
        for j in range(ABREAST):
            rows[30, j], rows[31, j] = kernels.place_on_line(
                rows[0, j], rows[25, j], rows[26, j], rows[28, j]
            )
        for j in range(ABREAST):
            rows[29, j] = table[first[j] + int(rows[31, j]), 4]
        kernels.move_abreast(rows, first, table, steps, dt)
        for k in range(10):
            for j in range(used):
                r[lists[a + 29 + k], begin + j] = rows[k, j]


def finite(r: Any, a: Any) -> Any:
    """Whether all of a register are numbers."""
    wrong = 0
    for j in range(r.shape[1]):
        if not np.isfinite(r[a, j]):
            wrong += 1
    return wrong == 0


def concerns(r: Any, a: Any) -> Any:
    """Whether a truth value is true of any agent."""
    true = 0
    for j in range(r.shape[1]):
        if r[a, j] > 0.5:
            true += 1
    return true > 0
