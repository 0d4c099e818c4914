"""Linear interpolation where every point has a table of its own."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..arrays import Floats


def interpolated_in_rows(
    at: Floats, rows: NDArray[np.intp], axis: Floats, columns: Sequence[Floats]
) -> list[Floats]:
    """What `np.interp(at[i], axis[rows[i]], column[rows[i]])` gives for each of the places `at`
    (R,), to the last bit, for each of the columns, (V, S) as the increasing `axis` is, or (1, S),
    of all rows."""
    of_axis = _in_table(rows, axis)
    last = axis.shape[1] - 1
    low = _places_in_one(at, axis[0]) if len(axis) == 1 else _places_before(at, of_axis, axis)
    high = np.minimum(low + 1, last)
    low = np.where(at >= axis[of_axis, last], last, low)
    start = axis[of_axis, low]
    spans, beyond = axis[of_axis, high] - start, at - start
    is_between = (beyond > 0.0) & (low < last)
    found = []
    for column in columns:
        which = _in_table(rows, column)
        before = column[which, low]
        with np.errstate(divide="ignore", invalid="ignore"):
            between = (column[which, high] - before) / spans * beyond + before
        found.append(np.where(is_between, between, before))
    return found


def _places_before(at: Floats, rows: NDArray[np.intp], axis: Floats) -> NDArray[np.intp]:
    """(R,) the last places, but for the very last, at which an axis is not beyond `at`; else 0."""
    low, high = np.zeros(len(at), dtype=np.intp), np.full(len(at), axis.shape[1] - 1)
    while (high - low > 1).any():
        middle = (low + high) // 2
        is_beyond = axis[rows, middle] <= at
        low, high = np.where(is_beyond, middle, low), np.where(is_beyond, high, middle)
    return low


def _places_in_one(at: Floats, axis: Floats) -> NDArray[np.intp]:
    """The same on one axis (S,) for all."""
    known = np.where(np.isnan(at), -np.inf, at)
    found = np.searchsorted(axis, known, side="right") - 1
    return np.clip(found, 0, max(len(axis) - 2, 0))


def _in_table(rows: NDArray[np.intp], table: Floats) -> NDArray[np.intp]:
    return rows if len(table) > 1 else np.zeros_like(rows)
