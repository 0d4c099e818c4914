"""Lines with fewer points that look the same."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..arrays import Floats, Integers


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
    x, y = np.concatenate(lines).T.copy()
    found = [starts, stops - 1]
    first, last = found
    with np.errstate(invalid="ignore", divide="ignore"):
        while True:
            open_ = (last - first > 1).nonzero()[0]  # the others have no point between their ends
            if not len(open_):
                break
            first, last = first[open_], last[open_]
            farthest, gaps = _farthest(x, y, first, last)  # of all stretches at once
            far = (gaps > tolerance).nonzero()[0]
            split = farthest[far]
            found.append(split)
            first, last = np.concatenate((first[far], split)), np.concatenate((split, last[far]))
    selected = np.unique(np.concatenate(found))
    parts = np.split(selected, np.searchsorted(selected, stops[:-1]))
    return [part - start for part, start in zip(parts, starts, strict=True)]


def _farthest(x: Floats, y: Floats, first: Integers, last: Integers) -> tuple[Integers, Floats]:
    """Of each stretch from one of `first` to that of `last`, the first point that is farthest from
    its chord, and how far that is."""
    counts = last - first
    begins = counts.cumsum() - counts
    of = np.arange(len(counts)).repeat(counts)
    at = np.arange(len(of)) + (first - begins)[of]
    from_x, from_y = x[first], y[first]
    chord_x, chord_y = x[last] - from_x, y[last] - from_y
    lengths = np.hypot(chord_x, chord_y)
    inner_x, inner_y = x[at] - from_x[of], y[at] - from_y[of]
    gaps = np.abs(inner_x * chord_y[of] - inner_y * chord_x[of]) / lengths[of]
    is_open = lengths > 0.0
    if not is_open.all():
        closed = ~is_open[of]
        gaps[closed] = np.hypot(inner_x[closed], inner_y[closed])
    most = np.maximum.reduceat(gaps, begins)
    at_most = (~(gaps < most[of])).nonzero()[0]
    return at[at_most[at_most.searchsorted(begins)]], most
