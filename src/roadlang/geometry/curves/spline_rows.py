"""Many splines at once, one after another in arrays; of each what it would be alone.

For a road of few points, to begin an operation of numpy takes longer than to do it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from ..arrays import Floats, Integers
from ..numbers.tridiagonal import solve_tridiagonal
from .gauss_legendre import path_lengths, subdivided
from .spline import PiecewiseCubic, cubics, interpolate

_FEWEST = 4
"""An open spline through fewer points is no system of equations."""


def lengths_of_pieces(splines: Sequence[PiecewiseCubic], cuts: int) -> list[Floats]:
    """The lengths (m, cuts) of equal steps of the m pieces of each spline."""
    row, stops = splines[0], splines[0].knots[1:]
    if len(splines) > 1:
        starts = np.concatenate([spline.knots[:-1] for spline in splines])
        stops = np.concatenate([spline.knots[1:] for spline in splines])
        coefficients = np.concatenate([spline.coefficients for spline in splines])
        row = PiecewiseCubic(np.append(starts, stops[-1:]), coefficients)
    inner = subdivided(row.knots[:-1], stops, cuts)
    ends = np.empty_like(inner)
    ends[:, :-1], ends[:, -1] = inner[:, 1:], stops
    piece = np.repeat(np.arange(len(stops)), cuts)
    lengths = path_lengths(row, inner.ravel(), ends.ravel(), piece).reshape(-1, cuts)
    return _parts(lengths, [len(spline.coefficients) for spline in splines])


def _parts(values: Floats, counts: Iterable[int]) -> list[Floats]:
    """So many values one after another, as views."""
    found, first = [], 0
    for count in counts:
        found.append(values[first : first + count])
        first += count
    return found


def interpolate_each(
    knots: Sequence[Floats], points: Sequence[Floats], closed: bool
) -> list[PiecewiseCubic]:
    """The C2 cubic through each row of points (n, 2) at its knots, as `interpolate`."""
    if closed or len(points) == 1:
        return [interpolate(*each, closed) for each in zip(knots, points, strict=True)]
    many = [index for index, row in enumerate(points) if len(row) >= _FEWEST]
    found = dict(zip(many, _open(*([a[i] for i in many] for a in (knots, points))), strict=True))
    return [
        found[index] if index in found else interpolate(knots[index], row, False)
        for index, row in enumerate(points)
    ]


def _open(knots: list[Floats], points: list[Floats]) -> list[PiecewiseCubic]:
    if not points:
        return []
    counts = np.array([len(row) for row in points])
    lasts = np.cumsum(counts) - 1
    along, place = np.concatenate(knots), np.concatenate(points)
    begins = np.ones(len(place), bool)
    begins[lasts] = False  # of the points, those at which a piece begins
    at = np.flatnonzero(begins)
    steps = along[at + 1] - along[at]
    chords = (place[at + 1] - place[at]) / steps[:, None]
    slopes = _slopes(steps, chords, at, counts)
    every = cubics(steps[:, None], place[at], chords, slopes[at], slopes[at + 1])
    parts = _parts(every, [len(row) - 1 for row in points])
    return [PiecewiseCubic(*each) for each in zip(knots, parts, strict=True)]


def _slopes(steps: Floats, chords: Floats, at: Integers, counts: Integers) -> Floats:
    """Derivatives (N, 2) at the knots of not-a-knot splines of so many points each, of which those
    `at` (M,) have a step (M,) and a chord (M, 2) after them; as of one spline in `spline`.

    The equations of one spline know nothing of those of the next.
    """
    total = int(counts.sum())
    lasts = np.cumsum(counts) - 1
    firsts = lasts - counts + 1
    before, after = np.empty(total), np.empty(total)
    chord_before, chord_after = np.empty((total, 2)), np.empty((total, 2))
    after[at], before[at + 1] = steps, steps
    chord_after[at], chord_before[at + 1] = chords, chords
    inner = np.ones(total, bool)
    inner[firsts], inner[lasts] = False, False
    k = np.flatnonzero(inner)
    bands, right = np.zeros((3, total)), np.empty((total, 2))
    bands[1, k] = 2.0 * (before[k] + after[k])
    bands[0, k + 1], bands[2, k - 1] = before[k], after[k]
    right[k] = 3.0 * (after[k, None] * chord_before[k] + before[k, None] * chord_after[k])
    for end, step, chord, way, band, off in (
        (firsts, after, chord_after, 1, 0, 1), (lasts, before, chord_before, -1, 2, -1),
    ):  # fmt: skip
        outer, within = step[end], step[end + way]
        bands[1, end], bands[band, end + off] = within, outer + within
        right[end] = _end_conditions(outer, within, chord[end], chord[end + way])
    return solve_tridiagonal(bands, right)


def _end_conditions(
    outer: Floats, inner: Floats, outer_chord: Floats, inner_chord: Floats
) -> Floats:
    both = outer + inner
    # The square of a number and that of an array may differ in the last bit.
    square = np.array([step**2 for step in outer])
    first = ((outer + 2.0 * both) * inner)[:, None] * outer_chord
    return np.asarray((first + square[:, None] * inner_chord) / both[:, None])
