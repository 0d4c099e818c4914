"""The greatest level that a window has often enough, or for long enough.

The values of a column are told apart by their ranks, bit by bit from the greatest: the samples
whose rank has the bit are put behind those that do not have it, and prefix sums of weights say how
much of a window is on either side (quantiles by wavelet trees; Navarro, Wavelet trees for all, CPM
2012). So a window costs the logarithm of the number of samples, whatever its length.
"""

from __future__ import annotations

import numpy as np

from .trace import FloatArray
from .weights import WeighedWindows


def greatest_level(values: FloatArray, windows: WeighedWindows) -> FloatArray:
    """(count, r): the greatest level at which the samples of a window that are no lower weigh
    more than `enough`, from `values` (n, r); -inf where there is none, inf below 0."""
    if windows.starts.size == 1:
        return _of_single_window(values, windows)
    found = np.stack(
        [_of_column(np.ascontiguousarray(column), windows) for column in values.T], axis=1
    )
    return _with_nothing_asked(found, windows)


def _with_nothing_asked(found: FloatArray, windows: WeighedWindows) -> FloatArray:
    found[windows.enough < 0] = np.inf
    return found


def _of_single_window(values: FloatArray, windows: WeighedWindows) -> FloatArray:
    start, end = int(windows.starts[0]), int(windows.ends[0])
    inside = -values[start : end + 1]
    if not inside.size:
        return _with_nothing_asked(np.full((1, values.shape[1]), -np.inf), windows)
    weights = windows.weights[start : end + 1].copy()
    weights[-1] = windows.last[0]
    order = np.argsort(inside, axis=0, kind="stable")
    reached = np.cumsum(weights[order], axis=0) > windows.enough[0]
    first = np.argmax(reached, axis=0)[None]
    level = -np.take_along_axis(np.take_along_axis(inside, order, axis=0), first, axis=0)
    return _with_nothing_asked(np.where(reached[-1], level, -np.inf), windows)


def _of_column(values: FloatArray, windows: WeighedWindows) -> FloatArray:
    """As `greatest_level`, of one column (n,): (count,). The last sample of a window is looked at
    by itself, as its weight is."""
    order = np.argsort(values, kind="stable")
    ranks = np.empty(values.size, dtype=np.intp)
    ranks[order] = np.arange(values.size)
    held = windows.ends >= windows.starts
    last_rank = ranks[np.where(held, windows.ends, 0)]
    starts = np.where(held, windows.starts, 0)
    ends = np.where(held, windows.ends, 0)  # without the last sample
    enough, found = windows.enough.copy(), np.zeros(starts.size, dtype=np.intp)
    arranged, weights = ranks, windows.weights
    for bit in range(int(values.size - 1).bit_length() - 1, -1, -1):
        above = (arranged >> bit) & 1 == 1
        counted = np.concatenate([[0], np.cumsum(above)])
        weighed = np.concatenate([[0.0], np.cumsum(np.where(above, weights, 0.0))])
        first, end = counted[starts], counted[ends]
        is_last_above = held & (last_rank >> bit == (found << 1) + 1)
        weight = weighed[ends] - weighed[starts] + np.where(is_last_above, windows.last, 0.0)
        up = weight > enough
        enough -= np.where(up, 0.0, weight)
        found = (found << 1) + up
        below = values.size - int(counted[-1])
        starts = np.where(up, below + first, starts - first)
        ends = np.where(up, below + end, ends - end)
        arranged = np.concatenate([arranged[~above], arranged[above]])
        weights = np.concatenate([weights[~above], weights[above]])
    weighed = np.concatenate([[0.0], np.cumsum(weights)])
    left = weighed[ends] - weighed[starts]
    left += np.where(held & (last_rank == found), windows.last, 0.0)
    level: FloatArray = np.where(left > enough, values[order[np.minimum(found, values.size - 1)]],
                                 -np.inf)  # fmt: skip
    return level
