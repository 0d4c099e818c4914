"""Smoothing splines of even points: penalized second differences (Whittaker 1923, Eilers 2003)."""

from __future__ import annotations

import numpy as np
from scipy.linalg import LinAlgError
from scipy.linalg.lapack import dpbsv
from scipy.ndimage import maximum_filter1d
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import splu

from roadlang.geometry import Floats

_PIN = 1e6


def resample(points: Floats, step: float = 1.0) -> Floats:
    """The polyline (n, 2) with points about every `step`, ends kept."""
    station = stations(points)
    count = max(2, round(station[-1] / step) + 1)
    at = evenly(float(station[-1]), count)
    x, y = points.T
    return np.column_stack([np.interp(at, station, x), np.interp(at, station, y)])


def evenly(last: float, count: int) -> Floats:
    """As `numpy.linspace` of `count` > 1 values from 0 on, in half the time."""
    values = np.arange(count) * (last / (count - 1))
    values[-1] = last
    return np.asarray(values)


def stations(points: Floats) -> Floats:
    """Length along the polyline at each point."""
    steps, along = points[1:] - points[:-1], np.zeros(max(1, len(points)))
    np.cumsum(np.hypot(steps[:, 0], steps[:, 1]), out=along[1:])
    return along


def smooth(
    points: Floats,
    wavelength: float,
    tolerance: float,
    tightest: float = 0.0,
    weights: Floats | None = None,
    closed: bool = False,
    free: tuple[bool, bool] = (False, False),
) -> Floats:
    """Points (n, 2), a pixel apart, without waves below `wavelength`; ends stay unless `free`.

    The curve stays within `tolerance` of points of full weight: the wavelength shrinks until it
    does. Then, where the radius is below `tightest`, the points' pull is eased until it is not.
    A closed line does not repeat its first point.
    """
    pull = np.ones(len(points)) if weights is None else np.asarray(weights, float).copy()
    stiffness = (wavelength / (2 * np.pi)) ** 4
    if len(points) < 5:
        return points
    for _ in range(6):
        curve = _solve(points, pull, stiffness, closed, free)
        away = np.hypot(*(curve - points).T)[pull >= 1]
        if not len(away) or away.max() <= tolerance:
            break
        stiffness /= 4
    for _ in range(8 if tightest > 0 else 0):
        sharp = curvature(curve, closed) > 1 / tightest
        if not sharp.any():
            break
        near = maximum_filter1d(sharp, 2 * int(tightest) + 3)
        pull = np.where(near & (pull <= 1), pull / 4, pull)
        curve = _solve(points, pull, max(stiffness, 1.0), closed, free)
    return curve


def gradient(points: Floats) -> Floats:
    """As `numpy.gradient` along points (n, 2), which takes longer for few of them."""
    found = np.empty(points.shape)
    found[1:-1] = (points[2:] - points[:-2]) / 2
    found[0], found[-1] = points[1] - points[0], points[-1] - points[-2]
    return found


def curvature(points: Floats, closed: bool = False) -> Floats:
    """Unsigned curvature (n,) of points about evenly spaced, in one over their unit."""
    padded = np.vstack([points[-2:], points, points[:2]]) if closed else points
    first = gradient(padded)
    second = gradient(first)
    cross = np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
    bend = cross / np.maximum(np.hypot(*first.T), 1e-9) ** 3
    return np.asarray(bend[2:-2] if closed else bend)


def smooth_values(
    values: Floats, wavelength: float, closed: bool = False, weights: Floats | None = None
) -> Floats:
    """Values (n,) at even points rid of waves shorter than `wavelength`; ends are free."""
    if len(values) < 5:
        return values
    pull = np.ones(len(values)) if weights is None else weights
    return _system(values[:, None], pull, (wavelength / (2 * np.pi)) ** 4, closed)[:, 0]


def _solve(
    points: Floats, pull: Floats, stiffness: float, closed: bool, free: tuple[bool, bool]
) -> Floats:
    if closed:
        return _system(points, pull, stiffness, True)
    ends = [end for end, is_free in zip((0, -1), free, strict=True) if not is_free]
    pinned = pull.copy()
    pinned[ends] = _PIN
    curve = _system(points, pinned, stiffness, False)
    curve[ends] = points[ends]
    return curve


def _system(values: Floats, pull: Floats, stiffness: float, closed: bool) -> Floats:
    """Minimize sum pull (x - values)^2 + stiffness sum (second difference of x)^2."""
    count = len(values)
    if closed:
        at = np.arange(count)
        around = [(at + step) % count for step in range(-2, 3)]
        weights = [stiffness * factor for factor in (1.0, -4.0, 6.0, -4.0, 1.0)]
        entries = np.repeat(np.array(weights)[:, None], count, axis=1)
        entries[2] = pull + entries[2] + 1e-12
        places = (np.tile(at, 5), np.concatenate(around))
        system = csc_matrix((entries.ravel(), places), shape=(count, count))
        return np.asarray(splu(system).solve(pull[:, None] * values))
    banded = np.zeros((3, count))
    banded[0] = pull
    for offset, row in ((0, (1.0, 4.0, 1.0)), (1, (-2.0, -2.0)), (2, (1.0,))):
        for k, value in enumerate(row):
            banded[offset, k : k + count - 2] += stiffness * value
    return banded_solution(banded, pull[:, None] * values)


def banded_solution(system: Floats, right: Floats) -> Floats:
    """Of a positive definite system, given by its diagonals (k, n) from the main one down.

    The same as `scipy.linalg.solveh_banded`, in a fifth of the time for short lines. Both arrays
    may be overwritten.
    """
    _, found, failed = dpbsv(system, right, lower=1, overwrite_ab=1, overwrite_b=1)
    if failed:
        raise LinAlgError(f"minor {failed} is not positive definite")
    return np.asarray(found)
