"""Cubic splines through the points of many lines at once: of each line what `splined` gives.

For a line of few points, to begin an operation of numpy takes longer than to do it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg.lapack import dgtsv

from roadlang.geometry import Floats

Indices = NDArray[np.intp]
FEWEST = 4
"""Splines through fewer points are no systems of equations."""


@dataclass(frozen=True)
class _Rows:
    """Points (N, 2) of open lines one after another, the parameter (N,) of each; indices of the
    `first` and the `last` point of each line, and of the points `at` (M,) which a piece begins."""

    points: Floats
    station: Floats
    first: Indices
    last: Indices
    at: Indices

    @staticmethod
    def of(lines: Sequence[Floats], stations: Sequence[Floats]) -> _Rows:
        counts = np.array([len(line) for line in lines])
        last = np.cumsum(counts) - 1
        begins = np.ones(int(counts.sum()), bool)
        begins[last] = False
        at = np.flatnonzero(begins)
        return _Rows(np.concatenate(lines), np.concatenate(stations), last - counts + 1, last, at)


def splined_each(
    lines: Sequence[Floats], stations: Sequence[Floats], places: Sequence[Floats]
) -> list[Floats]:
    """The C2 cubic through each line (n, 2), n >= `FEWEST`, at increasing parameters (n,), seen at
    some places (m,) between the first and the last."""
    rows = _Rows.of(lines, stations)
    at = rows.at
    step = (rows.station[at + 1] - rows.station[at])[:, None]
    chord = (rows.points[at + 1] - rows.points[at]) / step
    slope = _slopes(rows, step, chord)
    bend = (slope[at] + slope[at + 1] - 2 * chord) / step
    square, cube = (chord - slope[at]) / step - bend, bend / step
    piece = np.concatenate([
        first + np.clip(np.searchsorted(station, place, side="right") - 1, 0, len(station) - 2)
        for first, station, place in zip(rows.first.tolist(), stations, places, strict=True)
    ])  # fmt: skip
    counts = [len(place) for place in places]
    along = (np.concatenate(places) - rows.station[piece])[:, None]
    curve = rows.points[piece] + slope[piece] * along
    # The pieces of a line are one less than its points.
    piece -= np.repeat(np.arange(len(lines)), counts)
    squared = along * along
    curve += square[piece] * squared
    curve += cube[piece] * (squared * along)
    return np.split(curve, np.cumsum(counts)[:-1])


def _slopes(rows: _Rows, step: Floats, chord: Floats) -> Floats:
    """Derivatives (N, 2) at the points; the equations of one line know nothing of the next's."""
    total, at, first, last = len(rows.points), rows.at, rows.first, rows.last
    before, after = np.empty(total), np.empty(total)
    before[at + 1], after[at] = step[:, 0], step[:, 0]
    chord_before, chord_after = np.empty((total, 2)), np.empty((total, 2))
    chord_before[at + 1], chord_after[at] = chord, chord
    inner = np.ones(total, bool)
    inner[first], inner[last] = False, False
    k = np.flatnonzero(inner)
    diagonal, right = np.empty(total), np.empty((total, 2))
    below, above = np.zeros(total), np.zeros(total)  # of each row, to its left and to its right
    diagonal[k], below[k], above[k] = 2 * (before[k] + after[k]), after[k], before[k]
    right[k] = 3 * (after[k, None] * chord_before[k] + before[k, None] * chord_after[k])
    station = rows.station
    above[first] = two = station[first + 2] - station[first]
    outer, within = after[first], after[first + 1]
    diagonal[first] = within
    ahead = ((outer + 2 * two) * within)[:, None] * chord_after[first]
    right[first] = (ahead + _squared(outer) * chord_after[first + 1]) / two[:, None]
    below[last] = two = station[last] - station[last - 2]
    outer, within = before[last], before[last - 1]
    diagonal[last] = within
    back = ((2 * two + outer) * within)[:, None] * chord_before[last]
    right[last] = (_squared(outer) * chord_before[last - 1] + back) / two[:, None]
    *_, found, _ = dgtsv(below[1:], diagonal, above[:-1], right)
    return np.asarray(found)


def _squared(values: Floats) -> Floats:
    """(n, 1): the square of a number and that of an array may differ in the last bit."""
    return np.array([[value**2] for value in values])
