"""Loops over agents that numba compiles. Python never runs them; what they do to the last bit is
said in numpy elsewhere: `motion.advance`, `poses.line_frames`, `BendSpeeds.at`."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import lines, vehicle

ABREAST = 32
"""Agents that are moved side by side: with the numbers of so many in one small array,
the compiler finds that they do not depend on each other, and computes several at once."""


def advanced(
    motions: Any, columns: Any, walks: Any, wanted: Any, places: Any, table: Any, steps: Any,
    dt: Any,
) -> None:  # fmt: skip
    """Fill the second of `motions`, (10, N), from the first, 10 columns, as `motion.advance`."""
    before, after = motions
    first, numbers = places
    count = after.shape[1]
    rows = np.empty((35, ABREAST))
    starts = np.empty(ABREAST, np.int64)
    for begin in range(0, count, ABREAST):
        used = min(ABREAST, count - begin)
        for j in range(ABREAST):  # what is beyond the last agent is like it
            i = begin + min(j, used - 1)
            fill(rows, j, i, before, columns, wanted, numbers)
            rows[34, j] = 1.0 if walks[i] else 0.0
            starts[j] = first[i]
            rows[29, j] = table[first[i] + int(rows[31, j]), 4]
        for _ in range(steps):
            for j in range(ABREAST):
                drive(rows, j, dt)
            for j in range(ABREAST):
                cell = int(rows[31, j])
                rows[29, j] = table[starts[j] + cell, 4]
                rows[32, j] = table[starts[j] + cell, 5]
                rows[33, j] = float(cell)
            for j in range(ABREAST):
                heading = rows[32, j] + rows[29, j] * (rows[30, j] - rows[33, j] * rows[27, j])
                angle = rows[4, j] * dt - (heading - rows[8, j])
                rows[5, j], rows[6, j] = vehicle.turned(rows[5, j], rows[6, j], angle)
                rows[8, j] = heading
        for k in range(10):
            for j in range(used):
                after[k, begin + j] = rows[k, j]


def fill(
    rows: Any, j: Any, i: Any, before: Any, columns: Any, wanted: Any, numbers: Any
) -> None:  # fmt: skip
    """Agent `i` in column `j`: its state (10), what it is (13), what it is to do (2), its line (4),
    the curvature there, how far it is along the table, its cell, and room for two more."""
    rows[0, j], rows[1, j], rows[2, j] = before[0][i], before[1][i], before[2][i]
    rows[3, j], rows[4, j], rows[5, j] = before[3][i], before[4][i], before[5][i]
    rows[6, j], rows[7, j], rows[8, j] = before[6][i], before[7][i], before[8][i]
    rows[9, j] = before[9][i]
    for k in range(13):
        rows[10 + k, j] = columns[k, i]
    rows[23, j], rows[24, j] = wanted[0][i], wanted[1][i]
    for k in range(4):
        rows[25 + k, j] = numbers[k, i]
    place_on_line(rows, j)


def place_on_line(rows: Any, j: Any) -> None:
    """How far along the table of its line column `j` is, and the number of the cell, with a part of
    it."""
    advance = rows[0, j] - rows[26, j]
    rows[30, j] = advance
    rows[31, j] = vehicle.least(vehicle.greatest(advance * rows[28, j], 0.0), rows[25, j])


def drive(rows: Any, j: Any, dt: Any) -> None:
    """One step of the equations of motion, but for the line, which comes next."""
    car = (
        rows[10, j], rows[11, j], rows[12, j], rows[13, j], rows[14, j], rows[15, j], rows[16, j],
        rows[17, j], rows[18, j], rows[19, j], rows[20, j],
    )  # fmt: skip
    tangent = vehicle.steered(rows[7, j], rows[23, j], rows[21, j], rows[22, j])
    motion = (rows[2, j], rows[3, j], rows[4, j])
    driven = vehicle.driven(motion, tangent, rows[9, j], rows[24, j], car, dt)
    walked = vehicle.walked(motion, tangent, rows[24, j], rows[10, j], dt)
    on_foot = rows[34, j] > 0.5
    speed = walked[0] if on_foot else driven[0]
    slide = walked[1] if on_foot else driven[1]
    yaw_rate = walked[2] if on_foot else driven[2]
    place, direction = (rows[0, j], rows[1, j]), (rows[5, j], rows[6, j])
    moved = vehicle.moved(place, (rows[2, j], speed, slide), direction, rows[29, j], dt)
    rows[0, j], rows[1, j] = moved
    rows[2, j], rows[3, j], rows[4, j], rows[7, j] = speed, slide, yaw_rate, tangent
    rows[9, j] = walked[3] if on_foot else driven[3]
    place_on_line(rows, j)


def framed(along: Any, first: Any, numbers: Any, table: Any, out: Any) -> None:
    """Fill `out`, (5, N), as `poses.line_frames`."""
    for i in range(along.shape[0]):
        last, origin, spacing, per_meter = numbers[:, i]
        advance = along[i] - origin
        place = int(vehicle.least(vehicle.greatest(advance * per_meter, 0.0), last))
        cell = table[first[i] + place]
        x, y, heading = lines.on_arc(cell, advance - place * spacing, spacing)
        out[0, i], out[1, i], out[2, i], out[3, i], out[4, i] = x, y, heading, cell[6], cell[7]


def looked_up(values: Any, shift: Any, along: Any, first: Any, numbers: Any, out: Any) -> None:
    """Fill `out`, (N,), with values of cells."""
    for i in range(along.shape[0]):
        last, origin, _, per_meter = numbers[:, i]
        advance = along[i] - origin
        cell = int(vehicle.least(vehicle.greatest(advance * per_meter, 0.0), last))
        out[i] = values[shift[i] + first[i] + cell]
