"""Where the edges of a road are, left and right of its center line: widths, recentering."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Floats

from ..colors.fast_median import median
from .sampled import sampled
from .smoothing import gradient, smooth_values

_STEP, _FINE, _COARSE = 0.25, 9.0, 0.5
"""Step across a road in pixels; `_COARSE` where edges are sought farther than `_FINE` pixels from
the center line."""
_ROWS, _TOGETHER = 256, 1024
"""Number of points that are sampled, and evaluated, together: arrays of more points do not stay in
a processor's cache."""


@dataclass(frozen=True)
class Sides:
    """Distances (n,) in pixels from the center line to the edges, NaN where none is found."""

    left: Floats
    right: Floats

    @property
    def seen(self) -> NDArray[np.bool_]:
        """Where both edges are seen."""
        return np.isfinite(self.left) & np.isfinite(self.right)

    def where(self, good: NDArray[np.bool_]) -> Sides:
        """The same, seen only where `good` (n,)."""
        return Sides(np.where(good, self.left, np.nan), np.where(good, self.right, np.nan))


@dataclass(frozen=True)
class CenterLine:
    """A polyline (n, 2); a `closed` one repeats its first point."""

    points: Floats
    closed: bool = False


def sides_of(
    lines: Sequence[CenterLine], surface: NDArray[np.float32], radius: float, level: float = 0.5
) -> list[Sides]:
    """Look along the normals of lines for where the surface (h, w), 0..1, falls through `level`;
    NaN where that is beyond its border.

    Many lines at a time: for short ones, to begin an operation of numpy takes longer than to do it.
    """
    if not lines:
        return []
    points = np.concatenate([line.points for line in lines])
    normal = normals_in_a_row(points, lines)
    found = np.empty((2, len(points)))
    for first in range(0, len(points), _TOGETHER):
        rows = slice(first, first + _TOGETHER)
        found[:, rows] = _edges(points[rows], normal[rows], surface, radius, level)
    ends = np.cumsum([len(line.points) for line in lines])[:-1]
    return [Sides(*each) for each in zip(*(np.split(side, ends) for side in found), strict=True)]


def _edges(
    points: Floats, normal: Floats, surface: NDArray[np.float32], radius: float, level: float
) -> tuple[Floats, Floats]:
    """Distances (n,) from points to the edges on their left and right, NaN where none is found."""
    step = _STEP if radius < _FINE else _COARSE
    away = np.arange(0, radius + step, step)
    ways = np.concatenate([away, -away])  # to the left, and to the right
    profile = across(points, normal, ways, surface).reshape(2 * len(points), len(away))
    below = profile < level
    below[:, 0] = False
    first = np.argmax(below, axis=1)
    row = np.arange(len(profile))
    high, low = profile[row, np.maximum(first - 1, 0)], profile[row, first]
    part = np.clip((high - level) / np.maximum(high - low, 1e-6), 0, 1)
    distance = (first - 1 + part) * step
    found = np.where(below[row, first] & (profile[:, 0] >= level), distance, np.nan)
    left, right = found[::2], found[1::2]
    return (
        np.where(_within(points + left[:, None] * normal, surface), left, np.nan),
        np.where(_within(points - right[:, None] * normal, surface), right, np.nan),
    )


def _within(places: Floats, surface: NDArray[np.float32]) -> NDArray[np.bool_]:
    """Whether places (n, 2) are in the picture: what is beyond its border is not known."""
    height, width = surface.shape
    with np.errstate(invalid="ignore"):
        return np.asarray(((places > -0.5) & (places < (width - 0.5, height - 0.5))).all(axis=1))


def normals(points: Floats, closed: bool = False) -> Floats:
    """Unit normals (n, 2) of a polyline; a closed one repeats its first point."""
    if closed:
        around = np.vstack([points[-2:-1], points, points[1:2]])
        tangent = (around[2:] - around[:-2]) / 2
    else:
        tangent = gradient(points)
    return _turned_left(tangent)


def _turned_left(tangent: Floats) -> Floats:
    tangent = tangent / np.maximum(np.hypot(*tangent.T), 1e-9)[:, None]
    return np.column_stack([-tangent[:, 1], tangent[:, 0]])


def normals_in_a_row(points: Floats, lines: Sequence[CenterLine]) -> Floats:
    """The `normals` (N, 2) of lines of at least two points each, one after the other; `points`
    (N, 2) are those of all of them."""
    last = np.cumsum([len(line.points) for line in lines]) - 1
    first = np.append(0, last[:-1] + 1)
    tangent = gradient(points)
    tangent[first] = points[first + 1] - points[first]
    tangent[last] = points[last] - points[last - 1]
    ring = np.flatnonzero([line.closed for line in lines])
    tangent[first[ring]] = (points[first[ring] + 1] - points[last[ring] - 1]) / 2
    tangent[last[ring]] = tangent[first[ring]]
    return _turned_left(tangent)


def across(
    points: Floats, normal: Floats, away: Floats, surface: NDArray[np.float32]
) -> NDArray[np.float32]:
    """The surface (h, w) along the normals (n, 2) of points (n, 2), (n, m), so far `away` (m,) to
    the left of each point."""
    found = np.empty((len(points), len(away)), np.float32)
    for first in range(0, len(points), _ROWS):
        rows = slice(first, first + _ROWS)
        x, y = (
            (points[rows, axis, None] + away * normal[rows, axis, None]).astype(np.float32)
            for axis in (0, 1)
        )
        found[rows] = sampled(surface, x, y)
    return found


def typical_width(found: Sides) -> float:
    """The median of the measured widths, NaN without any."""
    widths = (found.left + found.right)[found.seen]
    return median(widths) if len(widths) else float("nan")


def widths(found: Sides, fallback: float, wavelength: float, closed: bool) -> tuple[Floats, float]:
    """Smoothed widths (n,) and the standard deviation of what was seen about them."""
    typical = typical_width(found)
    if not np.isfinite(typical):
        return np.full(len(found.left), fallback), float("nan")
    raw = found.left + found.right
    good = found.seen & (np.abs(raw - typical) < 0.5 * typical)
    filled = np.where(good, raw, typical)
    even = smooth_values(filled, wavelength, closed, np.where(good, 1.0, 0.02))
    spread = median(np.abs((raw - even)[good])) * 1.4826 if good.any() else typical
    return np.maximum(even, 0.2 * typical), spread
