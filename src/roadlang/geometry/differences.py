"""Derivatives along stations by finite differences, for many rows at once."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from .arrays import Floats, Integers
from .errors import GeometryError


def station_gaps(stations: Floats, period: float | None) -> Floats:
    """From each station (S,) to the next; S of them with a `period`, else S - 1."""
    if period is None:
        return np.diff(stations)
    return np.diff(stations, append=stations[0] + period)


def derivative(
    values: Floats, stations: Floats, period: float | None = None, order: int = 1
) -> Floats:
    """The first or second derivative of `values` (..., S) along `stations` (S,).

    By second-order differences: each station uses its two neighbors, round the seam with a
    `period` (meters once round); the ends of an open row use up to four stations. On uneven
    stations the second derivative is first order. Raises GeometryError for fewer than three
    stations and for stations that do not increase, or do not end before the period.
    """
    if stations.ndim != 1 or len(stations) < 3:
        raise GeometryError("differences need at least three stations")
    gaps = station_gaps(stations, period)
    if not (gaps > 0.0).all():
        raise GeometryError("stations must increase, and end before the period")
    result = np.empty(values.shape)
    before, center, after = values[..., :-2], values[..., 1:-1], values[..., 2:]
    inner = result[..., 1:-1]
    if are_even(gaps):
        _even(before, center, after, float(gaps[0]), order, inner)
    else:
        count = len(stations) - 2
        _uneven(before, center, after, gaps[:count], gaps[1 : count + 1], order, inner)
    for end in (0, -1):
        index, offsets = _at_end(end, stations, gaps, order, period is not None)
        result[..., end] = values[..., index] @ weights(offsets, order)
    return result


def are_even(gaps: Floats) -> bool:
    """Whether all gaps are the same but for rounding."""
    return bool(np.ptp(gaps) <= 1e-9 * gaps.max())


def weights(offsets: Floats, order: int) -> Floats:
    """Weights of the values at `offsets` (n,) that give the derivative of `order` at offset 0."""
    return _weights(tuple(offsets.tolist()), order)


@lru_cache(maxsize=256)
def _weights(places: tuple[float, ...], order: int) -> Floats:
    """Kept, as batch after batch is differentiated on the same stations."""
    offsets = np.array(places)
    scale = np.abs(offsets).max()
    powers = np.vander(offsets / scale, increasing=True).T
    right = np.zeros(len(offsets))
    right[order] = math.factorial(order)
    found = np.asarray(np.linalg.solve(powers, right) / scale**order)
    found.setflags(write=False)
    return found


def _at_end(
    end: int, stations: Floats, gaps: Floats, order: int, periodic: bool
) -> tuple[Integers, Floats]:
    """The stations that tell the derivative at the first (0) or last (-1), and where they stand
    from it."""
    if periodic:
        index = np.array([-1, 0, 1]) if end == 0 else np.array([-2, -1, 0])
        around = gaps[[-1, 0]] if end == 0 else gaps[[-2, -1]]
        return index, np.array([-around[0], 0.0, around[1]])
    nearest = np.arange(min(order + 2, len(stations)))
    index = nearest if end == 0 else -1 - nearest
    return index, stations[index] - stations[end]


def _even(
    before: Floats, center: Floats, after: Floats, gap: float, order: int, out: Floats
) -> None:
    np.subtract(after, before, out=out) if order == 1 else np.add(after, before, out=out)
    if order == 2:
        out -= 2.0 * center
    out *= 1.0 / gap**2 if order == 2 else 0.5 / gap


def _uneven(
    before: Floats,
    center: Floats,
    after: Floats,
    gap: Floats,
    following: Floats,
    order: int,
    out: Floats,
) -> None:
    forward, backward = (after - center) / following, (center - before) / gap
    if order == 1:
        out[...] = (gap * forward + following * backward) / (gap + following)
    else:
        out[...] = 2.0 * (forward - backward) / (gap + following)
