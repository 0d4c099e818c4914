"""Cubic splines through points: as of `scipy.interpolate.CubicSpline`, which takes a fifth
of a second to import, and far longer to begin with the few points of a road."""

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
    step = (station[1:] - station[:-1])[:, None]
    chord = (points[1:] - points[:-1]) / step
    if closed:
        slope = _periodic_slopes(step, chord)
    else:
        slope = _slopes(station, step, chord) if len(points) > 3 else _of_parabola(step, chord)
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


def _of_parabola(step: Floats, chord: Floats) -> Floats:
    """Derivatives (3, 2) at three points of the parabola through them."""
    bend = (chord[1] - chord[0]) / (step[0] + step[1])
    return np.array(
        [chord[0] - step[0] * bend, chord[0] + step[0] * bend, chord[1] + step[1] * bend]
    )


def _periodic_slopes(step: Floats, chord: Floats) -> Floats:
    """Derivatives (n, 2) at the points of a closed spline, the first of them repeated.

    The last unknown is taken out of the cycle, which leaves three diagonals.
    """
    h, count = step[:, 0], len(step)
    if count == 2:
        return np.tile((chord / step).sum(axis=0) / (1 / step).sum(axis=0), (3, 1))
    before = np.roll(step, 1, axis=0)
    diagonal = 2 * (h + before[:, 0])
    right = 3 * (step * np.roll(chord, 1, axis=0) + before * chord)
    out = np.zeros(count - 1)
    out[0], out[-1] = -h[0], -h[-3]
    *_, found, _ = dgtsv(
        h[1:-1], diagonal[:-1], np.append(h[-1], h[: count - 3]), np.column_stack([right[:-1], out])
    )
    alone, by_last = found[:, :2], found[:, 2:]
    last = (right[-1] - h[-2] * alone[0] - h[-1] * alone[-1]) / (
        diagonal[-1] + h[-2] * by_last[0] + h[-1] * by_last[-1]
    )
    slopes = np.vstack([alone + last * by_last, last])
    return np.vstack([slopes, slopes[:1]])
