"""Lines with fewer points that look the same."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .arrays import Floats, Integers


def simplified(points: Floats, tolerance: float) -> Integers:
    """Indices of the points (n, 2) of a line that stays within `tolerance` of all of them (Ramer
    1972; Douglas and Peucker 1973)."""
    return all_simplified([points], tolerance)[0]


def all_simplified(lines: Sequence[Floats], tolerance: float) -> list[Integers]:
    """The same of each of some lines, in hardly more time than of one."""
    if not lines:
        return []
    stops = np.cumsum([len(line) for line in lines])
    starts = np.concatenate([[0], stops[:-1]])
    points = lines[0] if len(lines) == 1 else np.concatenate(lines)
    # From the end of a line to the start of the next there is no point that could be far away.
    selected = np.unique([starts, stops - 1])
    while len(points) > len(selected):
        farthest, gaps = _farthest(points, selected)  # of all stretches at once
        split = farthest[gaps > tolerance]
        if not len(split):
            break
        selected = np.sort(np.concatenate([selected, split]))
    parts = np.split(selected, np.searchsorted(selected, stops[:-1]))
    return [part - start for part, start in zip(parts, starts, strict=True)]


def _farthest(points: Floats, ends: Integers) -> tuple[Integers, Floats]:
    """Of each stretch from one of the ascending `ends` to the next, the first point that is
    farthest from its chord, and how far that is."""
    first, last = ends[:-1], ends[1:]
    counts = last - first
    inner = points[first[0] : last[-1]] - np.repeat(points[first], counts, axis=0)
    chord = points[last] - points[first]
    length = np.hypot(chord[:, 0], chord[:, 1])
    across = inner[:, 0] * np.repeat(chord[:, 1], counts)
    across -= inner[:, 1] * np.repeat(chord[:, 0], counts)
    lengths = np.repeat(length, counts)
    with np.errstate(invalid="ignore", divide="ignore"):
        gaps = np.abs(across) / lengths
    closed = ~(lengths > 0.0)
    if closed.any():
        gaps[closed] = np.hypot(inner[closed, 0], inner[closed, 1])
    most = np.maximum.reduceat(gaps, first)
    at_most = np.flatnonzero(~(gaps < np.repeat(most, counts)))
    return at_most[np.searchsorted(at_most, first)], most
