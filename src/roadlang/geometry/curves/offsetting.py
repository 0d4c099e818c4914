"""Polylines beside a curve, with no loop where a bend is tighter than the offset."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Booleans, Floats, Integers, cross, finite, norm
from ..errors import GeometryError
from .curve import Curve

_SEARCH_RATIO = 4.0
"""A fold is closed at a crossing at most this many offsets away along the curve: bends of up to
150 degrees. What crosses farther away is another part of the road, not a fold."""


def offset(curve: Curve, distance: ArrayLike, stations: ArrayLike) -> Floats:
    """(S, 2) points `distance` meters to the left of the curve at `stations` (S,).

    `distance` is a number or (S,). Inside a bend tighter than that, the parallel curve makes a
    loop; here all stations of the loop share the point where it closes, so that the line still
    has a point for each station and never runs backwards.
    """
    s = finite(stations, "stations").reshape(-1)
    if len(s) < 2:
        raise GeometryError("an offset needs at least two stations")
    away = np.broadcast_to(finite(distance, "an offset"), s.shape)
    base, normal = curve.at(s), curve.normal(s)
    curvature = curve.curvature(s)
    with np.errstate(divide="ignore", over="ignore"):
        radius = np.where(curvature * away > 0.0, 1.0 / np.abs(curvature), np.inf)
    clamped = base + (np.sign(away) * np.minimum(np.abs(away), radius))[:, None] * normal
    raw = base + away[:, None] * normal
    if not curve.closed:
        return _unfolded(base, raw, clamped, away)
    start = _quietest(_backwards(_ring(base), _ring(raw)))
    base, raw, clamped, away = (
        _ring(np.roll(line, -start, axis=0)) for line in (base, raw, clamped, away)
    )
    return np.roll(_unfolded(base, raw, clamped, away)[:-1], start, axis=0)


def _unfolded(base: Floats, raw: Floats, clamped: Floats, away: Floats) -> Floats:
    line = raw.copy()
    collapsed = np.zeros(len(line) - 1, dtype=bool)
    arc = np.concatenate([[0.0], np.cumsum(norm(np.diff(base, axis=0)))])
    for _ in range(len(line)):
        backwards = _backwards(base, line)
        if not backwards.any():
            break
        first, last = _run(backwards, collapsed)
        radius_of_search = _SEARCH_RATIO * float(np.abs(away[first : last + 2]).max())
        low = int(np.searchsorted(arc, arc[first] - radius_of_search))
        high = int(np.searchsorted(arc, arc[last + 1] + radius_of_search, side="right")) - 1
        crossing = _closest_crossing(line, low, first, last + 1, high)
        if crossing is None:
            start, stop, point = first, last + 1, clamped[first : last + 2].mean(axis=0)
        else:
            start, stop, point = crossing
        line[start : stop + 1] = point
        collapsed[start:stop] = True
    return line


def _backwards(base: Floats, line: Floats) -> Booleans:
    """Which steps of `line` go against those of `base`."""
    along = (np.diff(base, axis=0) * np.diff(line, axis=0)).sum(axis=1)
    size = norm(np.diff(base, axis=0)) * max(1.0, float(np.abs(line).max()))
    return np.asarray(along < -1e-13 * size)


def _run(backwards: Booleans, collapsed: Booleans) -> tuple[int, int]:
    """First and last step of the first run that is backwards, with what it touches."""
    bad = backwards | collapsed
    first = last = int(np.argmax(backwards))
    while first > 0 and bad[first - 1]:
        first -= 1
    while last + 1 < len(bad) and bad[last + 1]:
        last += 1
    return first, last


def _closest_crossing(
    line: Floats, low: int, first: int, after: int, high: int
) -> tuple[int, int, Floats] | None:
    """Where steps low..first of the line cross steps after..high, nearest to the fold.

    Returns the first and the last vertex to move, and the crossing.
    """
    if first <= low or high <= after:
        return None
    p, q = line[low:first], line[after:high]
    d, e = line[low + 1 : first + 1] - p, line[after + 1 : high + 1] - q
    between = q[None] - p[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        determinant = cross(d[:, None], e[None])
        t = cross(between, np.broadcast_to(e[None], between.shape)) / determinant
        u = cross(between, np.broadcast_to(d[:, None], between.shape)) / determinant
        hit = (t >= 0.0) & (t <= 1.0) & (u >= 0.0) & (u <= 1.0)
    if not hit.any():
        return None
    i, j = np.nonzero(hit)
    nearest = int(np.argmin(j - i))
    a, b = int(i[nearest]), int(j[nearest])
    return low + a + 1, after + b, p[a] + t[a, b] * d[a]


def _ring(line: Floats) -> Floats:
    return np.concatenate([line, line[:1]])


def _quietest(backwards: Booleans) -> int:
    """The vertex of a ring farthest from any backward step."""
    bad: Integers = np.flatnonzero(backwards)
    if len(bad) == 0:
        return 0
    count = len(backwards)
    gaps = np.diff(bad, append=bad[0] + count)
    widest = int(np.argmax(gaps))
    return int((bad[widest] + gaps[widest] // 2) % count)
