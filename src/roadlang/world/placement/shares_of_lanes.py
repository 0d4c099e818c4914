"""Places at a share of the length of several lanes, where things stand with their length."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...geometry.arrays import Floats, Integers
from ...geometry.routes.shortest import ROOM_TO_BEGIN


def at_share(shares: Floats, ends: Any) -> tuple[Integers, Floats]:
    """Which of several lanes (n,), and the arc length there, at shares of their whole length; of
    those that are long enough, where there are such."""
    begin, end = np.array(ends, float).T
    lengths = np.abs(end - begin)
    is_long = lengths >= ROOM_TO_BEGIN
    counted = np.where(is_long, lengths, 0.0) if is_long.any() else lengths
    sums = np.concatenate([[0.0], np.cumsum(counted)])
    at = np.clip(shares, 0.0, 1.0) * sums[-1]
    numbers = np.clip(np.searchsorted(sums, at, side="right") - 1, 0, len(lengths) - 1)
    while (counted[numbers] == 0.0).any():
        numbers = np.where(counted[numbers] == 0.0, numbers - 1, numbers)
    share = np.clip((at - sums[numbers]) / counted[numbers], 0.0, 1.0)
    return numbers, begin[numbers] + share * (end - begin)[numbers]


def within(ends: Floats, stations: Floats, lengths: Floats) -> Floats:
    """Arc lengths (n,) at which things of these lengths have both their ends in lanes, whose `ends`
    are (n, 2), as far as those are long enough."""
    low, high = ends.min(axis=1), ends.max(axis=1)
    half = np.minimum(lengths, high - low) / 2.0
    return np.asarray(np.clip(stations, low + half, high - half))
