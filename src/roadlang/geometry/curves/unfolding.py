"""Lines beside a line, without the loops that they make inside tight bends."""

from __future__ import annotations

import numpy as np

from ..arrays import Floats

SEEN_FROM = 0.35
"""Pixels, in figures: smaller loops are not seen."""


def unfolded_lines(line: Floats, center: Floats, tolerance: float = SEEN_FROM) -> list[Floats]:
    """What is left of an offset line (n, 2) without the loops that it makes inside bends tighter
    than the offset; (m, 2) each.

    A point belongs to it if no point of the center line (n, 2) is nearer than its own by more than
    `tolerance`. All are in one unit of length: pixels, unless the tolerance is given.
    """
    forward = (np.diff(line, axis=0) * np.diff(center, axis=0)).sum(axis=1)
    if (forward >= 0).all():
        return [line]
    distance = np.hypot(*(line - center).T)
    nearest = np.hypot(*(line[:, None] - center[None]).transpose(2, 0, 1)).min(axis=1)
    fine = np.concatenate([[False], nearest >= distance - tolerance, [False]])
    starts = np.flatnonzero(fine[1:] & ~fine[:-1])
    ends = np.flatnonzero(~fine[1:] & fine[:-1])
    return [line[a:b] for a, b in zip(starts, ends, strict=True) if b - a > 1]
