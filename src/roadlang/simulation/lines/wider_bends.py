"""Bends too tight for a vehicle, replaced by the least wider ones that it can drive."""

from __future__ import annotations

import math

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...geometry.junctions.connection_curves import ConnectionEnds, Fits, fitted, sampled
from ...geometry.junctions.corners import SMALLEST_RADIUS

EXTENSIONS = np.arange(0.0, 25.0)
"""Meters before and after a tight bend from which on a wider one may replace it."""
AVERAGED = 2
"""Points to each side over which the curvature is averaged."""
UNEVEN = 0.25
"""Meters longer that a wider bend may be for each meter that it is less even."""
NO_LIMITS = np.zeros((0, 3))
Columns = tuple[Floats, Floats, Floats, Floats]


def with_wider_bends(line: Columns, least: float) -> Columns:
    """A line, (n,) arc lengths, x, y and heading, with a radius of at least about `least` meters.

    Where it bends more, a line, an arc and a line, or two arcs, replace as little of it as they
    can; the first column stays that of the places replaced. What no such bend can replace stays.
    """
    place = 0
    while True:
        tight = np.flatnonzero(_is_tight(line, least)[place:])
        if not len(tight):
            return line
        first = place + int(tight[0])
        gaps = np.flatnonzero(np.diff(tight) > 2 * AVERAGED + 1)
        last = place + int(tight[gaps[0]] if len(gaps) else tight[-1])
        wider = _replaced(line, first, last, least)
        line, place = (line, last + 1) if wider is None else wider


def _is_tight(line: Columns, least: float) -> Booleans:
    s, _, _, heading = line
    low = np.maximum(np.arange(len(s)) - AVERAGED, 0)
    high = np.minimum(np.arange(len(s)) + AVERAGED, len(s) - 1)
    turned = heading[high] - heading[low]
    return np.asarray(np.abs(turned) * least > 1.001 * np.maximum(s[high] - s[low], 1e-6))


def _replaced(line: Columns, first: int, last: int, least: float) -> tuple[Columns, int] | None:
    """The line with a wider bend from about point `first` to `last`, and the point after it;
    None where there is none."""
    s = line[0]
    begins = np.unique(np.searchsorted(s, s[first] - EXTENSIONS))
    ends = np.unique(np.minimum(np.searchsorted(s, s[last] + EXTENSIONS), len(s) - 1))
    begin, end = (column.ravel() for column in np.meshgrid(begins, ends, indexing="ij"))
    keep = begin < end
    begin, end = begin[keep], end[keep]
    if not len(begin):
        return None
    fits = _fits(line, begin, end, SMALLEST_RADIUS / least)
    before, after = s[first] - s[begin], s[end] - s[last]
    longer = before + after + UNEVEN * np.abs(before - after)
    best = int(np.where(fits.drivable, longer, math.inf).argmin())
    if not fits.drivable[best]:
        return None
    return _joined(line, int(begin[best]), int(end[best]), fits, best, least / SMALLEST_RADIUS)


def _fits(line: Columns, begin: Integers, end: Integers, scale: float) -> Fits:
    """Curves between pairs of points, drawn smaller so that the tightest is that of junctions."""
    _, x, y, heading = line
    points = np.stack([x, y], axis=1) * scale
    unlimited = np.full(len(begin), math.inf)
    ends = ConnectionEnds(points[begin], heading[begin], points[end], heading[end], unlimited)
    return fitted(ends, NO_LIMITS)


def _joined(
    line: Columns, begin: int, end: int, fits: Fits, which: int, scale: float
) -> tuple[Columns, int]:
    """The line with one of the curves between two of its points, and the number of the next."""
    s, x, y, heading = line
    count = max(end - begin, 2)
    points, headings = sampled(fits, np.linspace(0.0, 1.0, count + 1)[1:-1])
    inner = np.linspace(s[begin], s[end], count + 1)[1:-1]
    new = inner, points[which, :, 0] * scale, points[which, :, 1] * scale, headings[which]
    laps = np.round((heading[end] - headings[which, -1]) / (2.0 * np.pi)) * 2.0 * np.pi
    joined = [
        np.concatenate([column[: begin + 1], part, column[end:]])
        for column, part in zip((s, x, y, heading), new, strict=True)
    ]
    joined[3][begin + count :] -= laps
    return (joined[0], joined[1], joined[2], joined[3]), begin + count + 1
