"""When somebody who goes on as now is in the lane of a car."""

from __future__ import annotations

import math

import numpy as np

from ...geometry.arrays import Floats, Integers

SOON = 6.0
"""Seconds: who comes to the lane later does not count yet."""
STEP = 0.5
TIMES: Floats = np.arange(0.0, SOON + 0.5 * STEP, STEP)
"""Seconds ahead at which it is looked where somebody who goes on as now will be."""


def stay(outside: Floats, ahead: Floats) -> tuple[Floats, Floats, Integers, Floats]:
    """(P,) seconds until somebody who goes on as now is in the lane, infinite for who is not there
    soon, and until it has left it again; the number in `TIMES` of the first; and how far ahead it
    is there, at least. `outside`, `ahead`: (T, P) at `TIMES`."""
    inside = outside < 0.0
    soon, each = inside.any(axis=0), np.arange(outside.shape[1])
    number = np.arange(len(TIMES))[:, None]
    first = inside.argmax(axis=0)
    before = np.maximum(first - 1, 0)
    step = outside[before, each] - outside[first, each]
    share = outside[before, each] / np.where(step > 0.0, step, 1.0)
    enters = np.where(first > 0, TIMES[before] + share * STEP, 0.0)
    gone = ~inside & (number > first)
    leaves = np.where(gone, TIMES[:, None], math.inf).min(axis=0)
    stays = inside & (TIMES[:, None] < leaves)
    nearest = np.where(stays, ahead, math.inf).min(axis=0)
    return np.where(soon, enters, math.inf), leaves, first, nearest
