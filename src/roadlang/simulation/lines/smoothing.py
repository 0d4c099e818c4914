"""Bends of lanes that no car can drive, such as the inner lane of a sharp corner, made drivable."""

from __future__ import annotations

import numpy as np

from ...geometry.arrays import Floats
from ...geometry.junctions.corners import SMALLEST_RADIUS
from .wider_bends import with_wider_bends

TIGHTEST = 0.2
"""1/m: lanes with sharper bends are made drivable there."""
UNDRIVABLE = 0.3
"""1/m: more than this must not be left, as a mean over `MEASURED` points to each side."""
MEASURED = 2
EASED = 1.5
"""Meters to each side over which the bends that replace others are averaged: wheels take time to
turn."""
HALF_WINDOW = 6.0
"""Meters to each side over which places are averaged: of a right angle remains a radius of 4 m."""
SPACING = 0.5
"""Meters between two points of a smoothed line."""


def is_tight(curvature: Floats, offset: Floats) -> bool:
    """Whether a line `offset` meters left of a curve bends too sharply somewhere."""
    left = 1.0 - curvature * offset
    return bool((np.abs(curvature) > TIGHTEST * left).any())


def drivable(x: Floats, y: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """(n,) s, x, y and heading of a line through points, of which as little as can be is replaced
    by bends of `SMALLEST_RADIUS`; where none fits, places are averaged. `s`: arc length of the
    original line up to there."""
    line = smoothed(x, y, 0.0)
    s, x_wide, y_wide, _ = with_wider_bends(line, SMALLEST_RADIUS)
    gone, *wide = smoothed(x_wide, y_wide, EASED)
    bend = np.abs(wide[2][2 * MEASURED :] - wide[2][: -2 * MEASURED])
    if bend.size and bend.max() > UNDRIVABLE * 2 * MEASURED * SPACING:
        return smoothed(x, y)
    chords = np.hypot(np.diff(x_wide), np.diff(y_wide))
    before = np.interp(gone, np.concatenate([[0.0], np.cumsum(chords)]), s)
    return before, wide[0], wide[1], wide[2]


def smoothed(
    x: Floats, y: Floats, half_window: float = HALF_WINDOW
) -> tuple[Floats, Floats, Floats, Floats]:
    """(n,) s, x, y and heading of a line through points, each place averaged over `half_window`
    meters to each side; less near the ends, which stay. `s`: arc length of the original line up to
    there. Of a right angle remains a radius of 0.7 times as much."""
    s = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])
    fresh = np.append(True, np.diff(s) > 1e-6)
    s, x, y = s[fresh], x[fresh], y[fresh]
    even = np.linspace(0.0, s[-1], max(3, int(np.ceil(s[-1] / SPACING)) + 1))
    half_windows = np.minimum(half_window, np.minimum(even, s[-1] - even))
    columns = [_averaged(s, column, even, half_windows) for column in (x, y)]
    heading = np.arctan2(*(np.gradient(column, even) for column in columns[::-1]))
    return even, columns[0], columns[1], np.unwrap(heading)


def _averaged(s: Floats, values: Floats, at: Floats, half_window: Floats) -> Floats:
    """Means over `at - reach` to `at + reach` of what is linear between `s`."""
    fine = np.unique(np.concatenate([s, at, at - half_window, at + half_window]))
    fine = fine[(fine >= s[0]) & (fine <= s[-1])]
    column = np.interp(fine, s, values)
    area = np.concatenate([[0.0], np.cumsum(0.5 * (column[1:] + column[:-1]) * np.diff(fine))])
    sums = np.interp(at + half_window, fine, area) - np.interp(at - half_window, fine, area)
    wide = half_window > 1e-9
    means = sums / np.where(wide, 2.0 * half_window, 1.0)
    return np.asarray(np.where(wide, means, np.interp(at, s, values)))
