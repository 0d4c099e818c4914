"""Loops over agents that numba compiles. Python never runs them; what they do to the last bit is
said in numpy elsewhere: `motion.advance`, `poses.line_frames`, `poses.points_beside`,
`BendSpeeds.at`, `bend_speeds.planned`, `corridors.nearest_in_corridor`."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..lines import lines
from . import vehicle_dynamics as dynamics

ABREAST = 32
"""Agents that are moved side by side: with the numbers of so many in one small array,
the compiler finds that they do not depend on each other, and computes several at once. It does so
as long as the loop over them calls nothing: formulas take numbers and no arrays (which are
counted), and are put in where they are called (`forceinline`)."""


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
        move_abreast(rows, starts, table, steps, dt)
        for k in range(10):
            for j in range(used):
                after[k, begin + j] = rows[k, j]


def move_abreast(rows: Any, starts: Any, table: Any, steps: Any, dt: Any) -> None:
    """Some steps of all columns."""
    for _ in range(steps):
        drive_abreast(rows, dt)
        for j in range(ABREAST):
            cell = int(rows[31, j])
            rows[29, j] = table[starts[j] + cell, 4]
            rows[32, j] = table[starts[j] + cell, 5]
            rows[33, j] = float(cell)
        turn_abreast(rows, dt)


def fill(
    rows: Any, j: Any, i: Any, before: Any, columns: Any, wanted: Any, numbers: Any
) -> None:  # fmt: skip
    """Agent `i` in column `j`: its state (10), what it is (13), what it is to do (2), its line (4),
    room for the curvature there, how far it is along the table, its cell, and room for two more."""
    rows[0, j], rows[1, j], rows[2, j] = before[0][i], before[1][i], before[2][i]
    rows[3, j], rows[4, j], rows[5, j] = before[3][i], before[4][i], before[5][i]
    rows[6, j], rows[7, j], rows[8, j] = before[6][i], before[7][i], before[8][i]
    rows[9, j] = before[9][i]
    for k in range(13):
        rows[10 + k, j] = columns[k, i]
    rows[23, j], rows[24, j] = wanted[0][i], wanted[1][i]
    for k in range(4):
        rows[25 + k, j] = numbers[k, i]
    rows[30, j], rows[31, j] = place_on_line(rows[0, j], rows[25, j], rows[26, j], rows[28, j])


def drive_abreast(rows: Any, dt: Any) -> None:
    """One step of all columns, but for their lines."""
    for j in range(ABREAST):
        state = (
            rows[0, j], rows[1, j], rows[2, j], rows[3, j], rows[4, j], rows[5, j], rows[6, j],
            rows[7, j], rows[9, j],
        )  # fmt: skip
        car = (
            rows[10, j], rows[11, j], rows[12, j], rows[13, j], rows[14, j], rows[15, j],
            rows[16, j], rows[17, j], rows[18, j], rows[19, j], rows[20, j],
        )  # fmt: skip
        wanted = (rows[23, j], rows[24, j], rows[21, j], rows[22, j])
        (
            rows[0, j], rows[1, j], rows[2, j], rows[3, j], rows[4, j], rows[7, j], rows[9, j],
        ) = drive(state, car, wanted, rows[34, j], rows[29, j], dt)  # fmt: skip
        rows[30, j], rows[31, j] = place_on_line(rows[0, j], rows[25, j], rows[26, j], rows[28, j])


def turn_abreast(rows: Any, dt: Any) -> None:
    """Headings of all columns, from those of their lines at the places that they came to."""
    for j in range(ABREAST):
        heading = rows[32, j] + rows[29, j] * (rows[30, j] - rows[33, j] * rows[27, j])
        angle = rows[4, j] * dt - (heading - rows[8, j])
        rows[5, j], rows[6, j] = dynamics.turned(rows[5, j], rows[6, j], angle)
        rows[8, j] = heading


def place_on_line(along: Any, last: Any, origin: Any, per_meter: Any) -> Any:
    """How far along the table of its line an agent is, and the number of the cell, with a part of
    it."""
    advance = along - origin
    return advance, dynamics.least(dynamics.greatest(advance * per_meter, 0.0), last)


def drive(state: Any, car: Any, wanted: Any, walks: Any, curvature: Any, dt: Any) -> Any:
    """One step of the equations of motion, but for the line, which comes next: arc length, offset,
    speeds along and to the left, yaw rate, tangent of the steering angle, and acceleration.

    `state`: these, with cosine and sine of the heading before the last two; `wanted`: tangent and
    acceleration, with lag and rate of the steering; `walks`: 1.0 for someone on foot.
    """
    along, offset, vx, vy, turning, cosine, sine, at_wheels, before = state
    tangent = dynamics.steered(at_wheels, wanted[0], wanted[2], wanted[3])
    motion = (vx, vy, turning)
    driven = dynamics.driven(motion, tangent, before, wanted[1], car, dt)
    walked = dynamics.walked(motion, tangent, wanted[1], car[0], dt)
    on_foot = walks > 0.5
    speed = walked[0] if on_foot else driven[0]
    slide = walked[1] if on_foot else driven[1]
    yaw_rate = walked[2] if on_foot else driven[2]
    acceleration = walked[3] if on_foot else driven[3]
    place = dynamics.moved((along, offset), (vx, speed, slide), (cosine, sine), curvature, dt)
    return place[0], place[1], speed, slide, yaw_rate, tangent, acceleration


def framed(along: Any, first: Any, numbers: Any, table: Any, out: Any) -> None:
    """Fill `out`, (5, N), as `poses.line_frames`."""
    for i in range(along.shape[0]):
        last, origin, spacing, per_meter = numbers[:, i]
        advance, part = place_on_line(along[i], last, origin, per_meter)
        place = int(part)
        cell = table[first[i] + place]
        x, y, heading = lines.on_arc(cell, advance - place * spacing, spacing)
        out[0, i], out[1, i], out[2, i], out[3, i], out[4, i] = x, y, heading, cell[6], cell[7]


def framed_ahead(
    along: Any, first: Any, numbers: Any, table: Any, out: Any, cells: Any
) -> None:  # fmt: skip
    """Fill `out`, (5, K, N), and `cells`, (K, N), as `poses.frames_ahead`."""
    for i in range(along.shape[1]):
        last, origin, spacing, per_meter = numbers[:, i]
        for k in range(along.shape[0]):
            advance, part = place_on_line(along[k, i], last, origin, per_meter)
            place = int(part)
            cells[k, i] = first[i] + place
            cell = table[first[i] + place]
            x, y, heading = lines.on_arc(cell, advance - place * spacing, spacing)
            out[0, k, i], out[1, k, i], out[2, k, i] = x, y, heading
            out[3, k, i], out[4, k, i] = cell[6], cell[7]


def points_beside(
    along: Any, left: Any, first: Any, numbers: Any, table: Any, out: Any
) -> None:  # fmt: skip
    """Fill `out`, (2, K, N), as `poses.points_beside`."""
    for i in range(along.shape[1]):
        last, origin, spacing, per_meter = numbers[:, i]
        for k in range(along.shape[0]):
            advance, part = place_on_line(along[k, i], last, origin, per_meter)
            place = int(part)
            cell, rest = table[first[i] + place], advance - place * spacing
            bend = cell[4] * rest
            ahead = rest - left[k, i] * (bend - 0.5 * cell[4] * spacing)
            across = 0.5 * bend * (rest - spacing) + left[k, i]
            out[0, k, i] = cell[0] + cell[2] * ahead - cell[3] * across
            out[1, k, i] = cell[1] + cell[3] * ahead + cell[2] * across


def looked_up(values: Any, shift: Any, along: Any, first: Any, numbers: Any, out: Any) -> None:
    """Fill `out`, (N,), with values of cells."""
    for i in range(along.shape[0]):
        last, origin, _, per_meter = numbers[:, i]
        _, part = place_on_line(along[i], last, origin, per_meter)
        out[i] = values[shift[i] + first[i] + int(part)]


def planned(table: Any, first: Any, lateral: Any, gain: Any, straight: Any, out: Any) -> None:
    """Fill `out`, (N, M), as `bend_speeds.planned` for open lines."""
    last = out.shape[1] - 1
    for i in range(out.shape[0]):
        least, after = np.inf, np.inf
        for m in range(last, -1, -1):
            curvature = dynamics.greatest(abs(table[first[i] + m, 6]), straight)
            ramp = gain[i] * m
            least = dynamics.least(least, lateral[i] / curvature + ramp)
            square = least - ramp
            out[i, m] = np.sqrt(dynamics.least(square, after))
            after = square


def gaps_in_corridors(
    pairs: Any, lines: Any, swept: Any, views: Any, outlines: Any, limits: Any, out: Any
) -> None:
    """Fill `out`, (3, P), with what `corridors.nearest_in_corridor` gives of pairs: the gaps, and
    cosine and sine of the line there. `pairs`: columns (P,) of windows and of outlines, half the
    width of the corridor and half the length of who drives in it; `lines`: x, y, cosine and sine
    (M, I) of the windows; `swept`: to the left and right of them; `views`: meters ahead (M,) and
    how far each looks (I,); `outlines`: six columns of them; `limits`: circles, the spacing of
    samples, and from where on something is ahead."""
    column, target, halves, own = pairs
    s, view = views
    x, y, cosine, sine, half_length, half_width = outlines
    circles, spacing, begin = limits
    found = np.empty((circles, 4))
    for p in range(column.shape[0]):
        i, t = column[p], target[p]
        out[0, p], out[1, p], out[2, p] = np.inf, 1.0, 0.0
        bar = dynamics.greatest(half_length[t] - half_width[t], 0.0)
        wide = bar + halves[p] + spacing + widest(swept, i)
        if not nearest_sample(lines, s, view[i], i, x[t], y[t])[1] < wide * wide:
            continue
        for c in range(circles):
            out_ = (-1.0 + c * (2.0 / (circles - 1))) * bar
            at_x, at_y = x[t] + out_ * cosine[t], y[t] + out_ * sine[t]
            place = nearest_sample(lines, s, view[i], i, at_x, at_y)[0]
            dx, dy = at_x - lines[0][place, i], at_y - lines[1][place, i]
            along, across = lines[2][place, i], lines[3][place, i]
            left = along * dy - across * dx
            free = halves[p] + (swept[0][place, i] if left > 0.0 else swept[1][place, i])
            if c == 0 or c == circles - 1:
                turned = abs(cosine[t] * along + sine[t] * across)
                aside = abs(sine[t] * along - cosine[t] * across)
                free = free + half_width[t] * (turned + aside - 1.0)
            found[c, 0] = s[place] + along * dx + across * dy
            found[c, 1] = 1.0 if abs(left) < free else 0.0
            found[c, 2], found[c, 3] = along, across
        for c in range(circles):
            begins = found[c, 0] - dynamics.least(half_width[t], half_length[t])
            is_ahead = found[circles // 2, 0] > 0.0 or begins > own[p] - begin
            fits = is_ahead and found[c, 1] > 0.5 and found[c, 0] < view[i] + spacing
            gap = begins - own[p] if fits else np.inf
            if c == 0 or gap < out[0, p]:
                out[0, p], out[1, p], out[2, p] = gap, found[c, 2], found[c, 3]


def nearest_sample(lines: Any, s: Any, view: Any, i: Any, x: Any, y: Any) -> Any:
    """The sample of the line of agent `i` in its view that is nearest to a place, and the square of
    its distance."""
    place, least = 0, np.inf
    for m in range(s.shape[0]):
        if s[m] <= view:
            off_x, off_y = x - lines[0][m, i], y - lines[1][m, i]
            square = off_x * off_x + off_y * off_y
            if square < least:
                place, least = m, square
    return place, least


def widest(swept: Any, i: Any) -> Any:
    """The most that agent `i` covers beyond its width, anywhere in its window."""
    most = dynamics.greatest(swept[0][0, i], swept[1][0, i])
    for m in range(1, swept[0].shape[0]):
        most = dynamics.greatest(most, dynamics.greatest(swept[0][m, i], swept[1][m, i]))
    return most
