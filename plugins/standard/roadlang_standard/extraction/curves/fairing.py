"""Fair curves: lines and arcs wherever what was seen allows them, smooth in between.

Of all curves within a tolerance of what was seen, the one that turns least and whose curvature
changes least: the sums of |curvature| and of |change of curvature| are small, which makes most of
the terms zero (total variation: Rudin, Osher, Fatemi 1992; trend filtering: Kim et al. 2009). No
change of curvature is an arc, no curvature a line. Solved by iteratively reweighted least squares.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Floats

from .edges import CenterLine, normals, normals_in_a_row
from .fair_lines import FairLine, FairLines, SeenOffsets, in_a_row
from .fair_system import differences, spread, system
from .smoothing import banded_solution, stations

_TURNING, _CHANGING = 1.0, 3.0
"""Weights of curvature and of its change, beside squares of pixels off what was seen."""
_FLATTEST, _EVENEST = 1e-5, 2e-6
"""Curvature in 1/px, and its change in 1/px^2, below which they count as none."""
_INSIDE, _BEYOND = 0.012, 4.0
"""Weights of squares of pixels within the tolerance, and beyond it."""
_EASING = 0.7
_PINNED = 1e5
_SHORTEST = 8
"""Lines of fewer points are left as they are."""
_OVERLAP = 600
"""Number of points repeated before and after a closed line: the artificial ends are then so far
away that they move no point by more than 1e-7 px."""
_TOGETHER = 4096
"""Number of points that are solved together: more do not stay in a processor's cache."""


@dataclass(frozen=True)
class Pace:
    """How many rounds there are, and the curvature and its change that count as none in the first
    of them: from round to round they are less."""

    rounds: int
    flattest: float = 1e-2
    evenest: float = 1e-3


ROUGHLY, FULLY, AGAIN = Pace(16), Pace(32), Pace(20, 1e-3, 1e-4)
"""For a curve that will be fitted again from the result, for one that is final, and for one that is
already fair but has to move a little."""


@dataclass(frozen=True)
class Rough:
    """A line of evenly spaced points (n, 2), and what was seen along it; a `closed` one repeats its
    first point."""

    points: Floats
    seen: SeenOffsets
    closed: bool = False


def faired(lines: Sequence[Rough], pace: Pace = FULLY) -> list[Floats]:
    """The fair curve near each of the lines, in order; so many points of it, and closed as it is.

    What becomes of a line does not depend on those that are given with it.
    """
    curves = [line.points for line in lines]
    for group in _groups(lines):
        some = [lines[index] for index in group]
        row = in_a_row([*map(_fair_line, some, _open_normals(some))], _TURNING, _CHANGING)
        moved = _moved(some, row.parts(_solved(row, pace)))
        for index, curve in zip(group, moved, strict=True):
            curves[index] = curve
    return curves


def _groups(lines: Sequence[Rough]) -> Iterator[list[int]]:
    """Indices of the lines that are solved together."""
    group: list[int] = []
    total = 0
    for index, line in enumerate(lines):
        if len(line.points) < _SHORTEST:
            continue
        if group and total + len(line.points) > _TOGETHER:
            yield group
            group, total = [], 0
        group.append(index)
        total += len(line.points)
    if group:
        yield group


def _open_normals(lines: Sequence[Rough]) -> list[Floats]:
    """The normals (n, 2) of each line, as if none were closed."""
    outlines = [CenterLine(line.points) for line in lines]
    found = normals_in_a_row(np.concatenate([line.points for line in lines]), outlines)
    return np.split(found, np.cumsum([len(line.points) for line in lines])[:-1])


def _fair_line(line: Rough, normal: Floats) -> FairLine:
    step = float(stations(line.points)[-1]) / (len(line.points) - 1)
    if not line.closed:
        return FairLine(line.seen, _bends(line.points, normal, step), step)
    turn = _around(line)
    around = line.points[turn]
    return FairLine(_repeated(line.seen, turn), _bends(around, normals(around), step), step)


def _around(line: Rough) -> NDArray[np.intp]:
    """The points of a closed line, once round, and before and after them those that they go on
    with: indices."""
    count = len(line.points) - 1
    overlap = min(count, _OVERLAP)
    return np.arange(-overlap, count + overlap) % count


def _moved(lines: Sequence[Rough], offsets: Sequence[Floats]) -> list[Floats]:
    """The lines with their points moved to the left by so much; of a closed line only those
    offsets count that are not repeated."""
    points = np.concatenate([line.points for line in lines])
    outlines = [CenterLine(line.points, line.closed) for line in lines]
    aside = np.concatenate([*map(_once_round, lines, offsets)])
    moved = points + aside[:, None] * normals_in_a_row(points, outlines)
    return np.split(moved, np.cumsum([len(line.points) for line in lines])[:-1])


def _once_round(line: Rough, offsets: Floats) -> Floats:
    """The offsets (n,) of the points of a line."""
    if not line.closed:
        return offsets
    count = len(line.points) - 1
    first = (len(offsets) - count) // 2
    return np.append(offsets[first : first + count], offsets[first])


def _repeated(seen: SeenOffsets, turn: NDArray[np.intp]) -> SeenOffsets:
    """The same for points of a closed line that are repeated, given by their indices."""
    offset, weight, tolerance = (
        values[turn] for values in (seen.offset, seen.weight, seen.tolerance)
    )
    pins = tuple(
        (place, value) for i, value in seen.pins for place in np.flatnonzero(turn == i).tolist()
    )
    return SeenOffsets(offset, weight, tolerance, pins)


def _bends(points: Floats, normal: Floats, step: float) -> Floats:
    """Signed curvature (n - 2,) of a line of even steps with its normals (n, 2), at all points but
    its ends."""
    return np.asarray((differences(points, 2) * normal[1:-1]).sum(axis=1) / step**2)


def _solved(row: FairLines, pace: Pace) -> Floats:
    """The offsets (N,) for which the curves are fair."""
    goal, weight, tolerance = row.seen.offset, row.seen.weight, row.seen.tolerance
    pinned = np.array([index for index, _ in row.seen.pins], int)
    pins = np.array([offset for _, offset in row.seen.pins])
    found, outside = np.zeros(len(goal)), np.zeros(len(goal))
    flattest, evenest = pace.flattest, pace.evenest
    inside = _INSIDE * goal
    for _ in range(pace.rounds):
        flattest, evenest = max(_FLATTEST, flattest * _EASING), max(_EVENEST, evenest * _EASING)
        off = found - goal
        outside = (outside + (np.abs(off) > tolerance)) / 2  # halves: or points go in and out
        beyond = _BEYOND * outside
        pull = weight * (_INSIDE + beyond) + 1e-9
        edge = goal + np.sign(off) * tolerance
        pulled = weight * (inside + beyond * edge)
        pull[pinned], pulled[pinned] = _PINNED, _PINNED * pins
        second = differences(found, 2)
        curvature = row.bend + second / row.square
        changed = row.change + differences(second, 1) / row.cube
        turning = row.turning / np.maximum(np.abs(curvature), flattest)
        changing = row.changing / np.maximum(np.abs(changed), evenest)
        right = pulled - spread(turning * row.bend, 2) + spread(changing * row.change, 3)
        found = banded_solution(system(pull, turning / row.square, changing / row.cube), right)
    return found
