"""Derivatives along stations by finite differences, for many rows at once."""

from __future__ import annotations

import math
from functools import cached_property, lru_cache

import numpy as np

from ..arrays import Floats, Integers
from ..errors import GeometryError

Stencil = tuple[float, tuple[Integers, Floats, Integers, Floats]]
"""A factor for the difference of the two neighbors; of the first and of the last station which
values count there, and their weights."""


def station_gaps(stations: Floats, period: float | None) -> Floats:
    """From each station (S,) to the next; S of them with a `period`, else S - 1."""
    if period is None:
        return np.diff(stations)
    return np.diff(stations, append=stations[0] + period)


def derivative(
    values: Floats, stations: Floats, period: float | None = None, order: int = 1
) -> Floats:
    """The first or second derivative of `values` (..., S) along `stations` (S,); see
    `Differences`."""
    return differences_on(stations, period).derivative(values, order)


def differences_on(stations: Floats, period: float | None = None) -> Differences:
    """Those along `stations` (S,): kept, as batch after batch is differentiated on the same."""
    return _differences(stations.tobytes(), period)


@lru_cache(maxsize=64)
def _differences(stations: bytes, period: float | None) -> Differences:
    return Differences(np.frombuffer(stations), period)


class Differences:
    """Differences along `stations` (S,): each uses its two neighbors, round the seam with a
    `period` (meters once round); the ends of an open row use up to four stations.

    Second order in the gap; on uneven stations the second derivative is first order. A row of
    values gives the same numbers whatever other rows there are. Raises GeometryError for fewer than
    three stations and for stations that do not increase, or do not end before the period.
    """

    def __init__(self, stations: Floats, period: float | None = None) -> None:
        if stations.ndim != 1 or len(stations) < 3:
            raise GeometryError("differences need at least three stations")
        self._gaps = station_gaps(stations, period)
        if not (self._gaps > 0.0).all():
            raise GeometryError("stations must increase, and end before the period")
        self._is_even = are_even(self._gaps)
        self._is_periodic = period is not None
        self._ends = {
            (end, order): _at_end(end, stations, self._gaps, order, period is not None)
            for end in (0, -1)
            for order in (1, 2)
        }

    @cached_property
    def stencil(self) -> Stencil | None:
        """The first derivative in numbers, for compiled loops; None on uneven stations."""
        if not self._is_even:
            return None
        count = len(self._gaps) + (not self._is_periodic)
        first, last = (self._ends[end, 1] for end in (0, -1))
        places = (np.array([index % count for index, _ in each]) for each in (first, last))
        weights = (np.array([weight for _, weight in each]) for each in (first, last))
        ends = [array for pair in zip(places, weights, strict=True) for array in pair]
        return 0.5 / float(self._gaps[0]), (ends[0], ends[1], ends[2], ends[3])

    def derivative(self, values: Floats, order: int = 1, out: Floats | None = None) -> Floats:
        """(..., S) of `values` (..., S), the first or the second; in `out` where there is one."""
        result = np.empty(values.shape) if out is None else out
        before, center, after = values[..., :-2], values[..., 1:-1], values[..., 2:]
        if not self._is_even:
            count = values.shape[-1] - 2
            gaps = self._gaps[:count], self._gaps[1 : count + 1]
            _uneven(before, center, after, *gaps, order, result[..., 1:-1])
        elif values.flags.c_contiguous and result.flags.c_contiguous:
            # One row of numbers is four times as fast as many short ones. What goes across from
            # the end of a row to the next is at the ends, which come below.
            flat, inner = values.reshape(-1), result.reshape(-1)[1:-1]
            _even(flat[:-2], flat[1:-1], flat[2:], float(self._gaps[0]), order, inner)
        else:
            _even(before, center, after, float(self._gaps[0]), order, result[..., 1:-1])
        for end in (0, -1):
            result[..., end] = self._at_end(values, end, order)
        return result

    def _at_end(self, values: Floats, end: int, order: int) -> Floats:
        """(...,) at the first (0) or last (-1) station. Not by `@`: how that rounds depends on how
        many rows there are."""
        (first, factor), *others = self._ends[end, order]
        total = values[..., first] * factor
        for index, factor in others:
            total += values[..., index] * factor
        return np.asarray(total)


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
) -> list[tuple[int, float]]:
    """The stations that tell the derivative at the first (0) or last (-1), each with its weight."""
    if periodic:
        index = np.array([-1, 0, 1]) if end == 0 else np.array([-2, -1, 0])
        around = gaps[[-1, 0]] if end == 0 else gaps[[-2, -1]]
        offsets = np.array([-around[0], 0.0, around[1]])
    else:
        nearest = np.arange(min(order + 2, len(stations)))
        index = nearest if end == 0 else -1 - nearest
        offsets = stations[index] - stations[end]
    return list(zip(index.tolist(), weights(offsets, order).tolist(), strict=True))


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
