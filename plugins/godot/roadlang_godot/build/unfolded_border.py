"""Borders of roads in bends that are tighter than the road is wide, without the fold."""

from __future__ import annotations

import numpy as np

from roadlang.geometry import Floats

WINDOW = 60
"""Samples before and after a fold in which the border crosses itself."""
MOST_FOLDS = 20
"""In one piece of road."""
_TINY = 1e-9


def unfolded(border: Floats, ahead: Floats) -> Floats:
    """A border (n, 2) that nowhere runs against its road.

    `ahead`: the heading of the road (n - 1,) between the samples. Inside a bend with a radius less
    than its distance from the middle, the border runs back; it is cut off where it crosses itself:
    all samples between lie in that point.
    """
    out = border
    for _ in range(MOST_FOLDS):
        steps = np.diff(out, axis=0)
        runs_back = steps[:, 0] * np.cos(ahead) + steps[:, 1] * np.sin(ahead) < -_TINY
        if not runs_back.any():
            break
        changes = np.flatnonzero(np.diff(np.concatenate([[0], runs_back.astype(int), [0]])))
        low, high, point = _crossing(out, int(changes[0]), int(changes[1]))
        out = out.copy()
        out[low : high + 1] = point
    return out


def _crossing(border: Floats, first: int, last: int) -> tuple[int, int, Floats]:
    """The samples between which a border crosses itself, around the pieces `first` to `last` - 1
    that run back, and the point; without a crossing, the middle of the fold."""
    before = np.arange(max(0, first - WINDOW), first)
    after = np.arange(last, min(len(border) - 1, last + WINDOW))
    p, q = border[before][:, None], border[after][None]
    u, v = border[before + 1][:, None] - p, border[after + 1][None] - q
    cross = u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
    gap = q - p
    with np.errstate(divide="ignore", invalid="ignore"):
        s = (gap[..., 0] * v[..., 1] - gap[..., 1] * v[..., 0]) / cross
        t = (gap[..., 0] * u[..., 1] - gap[..., 1] * u[..., 0]) / cross
    rows, columns = np.nonzero((s >= 0) & (s <= 1) & (t >= 0) & (t <= 1))
    if not len(rows):
        return first, last, border[first : last + 1].mean(axis=0)
    row, column = rows[-1], columns[-1]
    low, high = int(before[row]) + 1, int(after[column])
    point = border[low - 1] + s[row, column] * (border[low] - border[low - 1])
    return low, high, point
