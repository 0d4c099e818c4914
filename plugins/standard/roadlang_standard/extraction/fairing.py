"""Fair curves: lines and arcs wherever what was seen allows them, smooth in between.

Of all curves within a tolerance of what was seen, the one that turns least and whose curvature
changes least: the sums of |curvature| and of |change of curvature| are small, which makes most of
the terms zero (total variation: Rudin, Osher, Fatemi 1992; trend filtering: Kim et al. 2009). No
change of curvature is an arc, no curvature a line. Solved by iteratively reweighted least squares.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline

from roadlang.geometry import Floats

from .edges import normals
from .smoothing import banded_solution, stations

_TURNING, _CHANGING = 1.0, 3.0
"""Weights of curvature and of its change, beside squares of pixels off what was seen."""
_FLATTEST, _EVENEST = 1e-5, 2e-6
"""Curvature in 1/px, and its change in 1/px^2, below which they count as none."""
_INSIDE, _BEYOND = 0.012, 4.0
"""Weights of squares of pixels within the tolerance, and beyond it."""
_ROUNDS, _EASING = 32, 0.7
_PINNED = 1e5
_ZEROS = np.zeros(3)
_SECOND = tuple(np.array(row) for row in ((1.0, 4.0, 1.0), (-2.0, -2.0), (1.0,)))
_THIRD = tuple(
    np.array(row) for row in ((1.0, 9.0, 9.0, 1.0), (-3.0, -9.0, -3.0), (3.0, 3.0), (-1.0,))
)
"""Products of the second and the third difference's factors (1, -2, 1) and (-1, 3, -3, 1) that are
0, 1, 2 and 3 points apart."""


@dataclass(frozen=True)
class SeenOffsets:
    """What was seen along a curve of n points: `offset` (n,), pixels to the left of each point,
    how much it weighs (n,), 0 to 1, and the `tolerance` (n,) in pixels within which it is as good
    as met. `pins` are offsets that are met exactly, by the index of their point."""

    offset: Floats
    weight: Floats
    tolerance: Floats
    pins: tuple[tuple[int, float], ...] = ()


def even_points(points: Floats, closed: bool = False, step: float = 1.0) -> Floats:
    """Points (m, 2) about every `step` along the cubic spline through `points` (n, 2).

    A closed curve repeats its first point at the end, and so does the result.
    """
    apart = np.r_[True, np.hypot(*np.diff(points, axis=0).T) > 1e-9]
    points = points[apart]
    if len(points) < 3:
        length = float(stations(points)[-1])
        share = np.linspace(0.0, 1.0, max(2, round(length / step) + 1))
        return np.asarray(points[0] + share[:, None] * (points[-1] - points[0]))
    if closed:
        points = np.vstack([points[:-1], points[:1]])
    station = stations(points)
    spline = CubicSpline(station, points, bc_type="periodic" if closed else "not-a-knot")
    at = np.linspace(0.0, station[-1], max(2, round(float(station[-1]) / step) + 1))
    return np.asarray(spline(at))


def faired(points: Floats, seen: SeenOffsets, closed: bool = False) -> Floats:
    """The fair curve near `points` (n, 2), which are evenly spaced; so many points of it.

    A closed line repeats its first point, and so does the result.
    """
    if len(points) < 8:
        return points
    step = float(stations(points)[-1]) / (len(points) - 1)
    normal = normals(points, closed)
    if not closed:
        offsets = _solved(seen, _bends(points, step), step)
        return np.asarray(points + offsets[:, None] * normal)
    count = len(points) - 1  # three times round: the middle one has neighbors on both sides
    around = np.vstack([points[:-1]] * 3)
    offsets = _solved(_repeated(seen, count), _bends(around, step), step)[count : 2 * count]
    return np.asarray(points + np.append(offsets, offsets[0])[:, None] * normal)


def _repeated(seen: SeenOffsets, count: int) -> SeenOffsets:
    """The same three times round a closed line of so many points."""
    offset, weight, tolerance = (
        np.tile(values[:count], 3) for values in (seen.offset, seen.weight, seen.tolerance)
    )
    pins = tuple((i + turn * count, value) for turn in range(3) for i, value in seen.pins)
    return SeenOffsets(offset, weight, tolerance, pins)


def _bends(points: Floats, step: float) -> Floats:
    """Signed curvature (n - 2,) of a line of even steps, at all points but its ends."""
    return np.asarray((np.diff(points, 2, axis=0) * normals(points)[1:-1]).sum(axis=1) / step**2)


def _solved(seen: SeenOffsets, bend: Floats, step: float) -> Floats:
    """The offsets (n,) for which the curve is fair, of a line that bends by so much (n - 2,)."""
    goal, weight, change = seen.offset, step * seen.weight, np.diff(bend) / step
    found, outside = np.zeros(len(goal)), np.zeros(len(goal))
    flattest, evenest = 1e-2, 1e-3
    for _ in range(_ROUNDS):
        flattest, evenest = max(_FLATTEST, flattest * _EASING), max(_EVENEST, evenest * _EASING)
        off = found - goal
        outside = (outside + (np.abs(off) > seen.tolerance)) / 2  # halves: or points go in and out
        pull = weight * (_INSIDE + _BEYOND * outside) + 1e-9
        edge = goal + np.sign(off) * seen.tolerance
        pulled = weight * (_INSIDE * goal + _BEYOND * outside * edge)
        for index, offset in seen.pins:
            pull[index], pulled[index] = _PINNED, _PINNED * offset
        second = _differences(found, 2)
        curvature = bend + second / step**2
        changed = change + (second[1:] - second[:-1]) / step**3
        turning = _TURNING / step / np.maximum(np.abs(curvature), flattest)
        changing = _CHANGING / step**2 / np.maximum(np.abs(changed), evenest)
        right = pulled - _spread(turning * bend, 2)
        right += _spread(changing * change, 3)
        system = _system(pull, turning / step**2, changing / step**3)
        found = banded_solution(system, right)
    return found


def _differences(values: Floats, order: int) -> Floats:
    """As `numpy.diff`, which takes longer for short lines."""
    for _ in range(order):
        values = values[1:] - values[:-1]
    return values


def _spread(weighted: Floats, order: int) -> Floats:
    """The differences' transpose: (n,) of values (n - order,)."""
    return _differences(np.concatenate([_ZEROS[:order], weighted, _ZEROS[:order]]), order)


def _system(pull: Floats, turning: Floats, changing: Floats) -> Floats:
    """Of sums of weighted squares of values (n,) and of their second and third differences, the
    matrix, by its diagonals (4, n) from the main one down."""
    count = len(pull)
    banded = np.zeros((4, count))
    banded[0] = pull
    for weights, stencils in ((turning, _SECOND), (changing, _THIRD)):
        for below, stencil in enumerate(stencils):
            banded[below, : count - below] += np.convolve(weights, stencil)
    return banded
