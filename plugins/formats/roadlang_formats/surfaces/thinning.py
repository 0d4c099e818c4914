"""Fewer cross-sections of a strip that has the same shape."""

from __future__ import annotations

import numpy as np

from roadlang.geometry import Floats, Integers


def thinned(lines: Floats, tolerance: float, most: int) -> Integers:
    """Indices, first and last among them, of points shared by several lines (l, n, 3).

    The chords between the points stay within `tolerance` meters of all others of every line, and
    skip less than `most` of them. Each chord is the longest that starts where the last one ended.
    """
    count = lines.shape[1]
    found = [0]
    while found[-1] < count - 1:
        first = found[-1]
        good, step = first + 1, 1
        while step and good < count - 1:
            end = min(good + step, count - 1, first + most)
            if end > good and _is_straight(lines[:, first : end + 1], tolerance):
                good, step = end, 2 * step
            else:
                step //= 2
        found.append(good)
    return np.array(found)


def _is_straight(lines: Floats, tolerance: float) -> bool:
    chord = lines[:, -1] - lines[:, 0]
    inner = lines[:, 1:-1] - lines[:, :1]
    length = np.maximum((chord**2).sum(axis=1), 1e-12)
    share = np.clip(np.einsum("lnk,lk->ln", inner, chord) / length[:, None], 0.0, 1.0)
    away = inner - share[..., None] * chord[:, None]
    return bool((away**2).sum(axis=2).max(initial=0.0) <= tolerance**2)
