"""Cubic splines through points: as of `scipy.interpolate.CubicSpline`, which takes far longer to
begin with the few points of a road."""

from __future__ import annotations

import numpy as np
from scipy.linalg.lapack import dgtsv

from roadlang.geometry import Floats


def splined(station: Floats, points: Floats, at: Floats, closed: bool = False) -> Floats:
    """The C2 cubic (m, 2) through `points` (n, 2), n > 2, at increasing parameters `station` (n,),
    seen at parameters `at` (m,) between the first and the last.

    Its ends are not knots (de Boor 1978, ch. IV); a closed one is periodic and repeats its first
    point.
    """
    if closed or len(points) < 4:
        # Here: it takes a tenth of a second to import, and most pictures have no closed road.
        from scipy.interpolate import CubicSpline

        ends = "periodic" if closed else "not-a-knot"
        return np.asarray(CubicSpline(station, points, bc_type=ends)(at))
    step = np.diff(station)[:, None]
    chord = np.diff(points, axis=0) / step
    slope = _slopes(station, step, chord)
    bend = (slope[:-1] + slope[1:] - 2 * chord) / step
    piece = np.clip(np.searchsorted(station, at, side="right") - 1, 0, len(points) - 2)
    along = (at - station[piece])[:, None]
    curve = points[piece] + slope[piece] * along
    square = along * along
    curve += ((chord - slope[:-1]) / step - bend)[piece] * square
    curve += (bend / step)[piece] * (square * along)
    return np.asarray(curve)


def _slopes(station: Floats, step: Floats, chord: Floats) -> Floats:
    """Derivatives (n, 2) at the points of an open spline."""
    h, count = step[:, 0], len(station)
    diagonal, right = np.empty(count), np.empty((count, 2))
    diagonal[1:-1] = 2 * (h[:-1] + h[1:])
    right[1:-1] = 3 * (step[1:] * chord[:-1] + step[:-1] * chord[1:])
    first, last = station[2] - station[0], station[-1] - station[-3]
    diagonal[0], diagonal[-1] = h[1], h[-2]
    right[0] = ((h[0] + 2 * first) * h[1] * chord[0] + h[0] ** 2 * chord[1]) / first
    right[-1] = (h[-1] ** 2 * chord[-2] + (2 * last + h[-1]) * h[-2] * chord[-1]) / last
    below, above = np.append(h[1:], last), np.append(first, h[:-1])
    *_, found, _ = dgtsv(below, diagonal, above, right)
    return np.asarray(found)
