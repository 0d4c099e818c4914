"""Derivatives along stations by finite differences, for many rows at once."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from .arrays import Floats
from .errors import GeometryError


@dataclass(frozen=True, eq=False)
class Stencil:
    """Second-order differences at `stations` (S,); `period` meters round if closed, else None.

    Interior stations use their two neighbors, the ends of an open row up to four stations.
    On uneven stations the second derivative is first order.
    """

    stations: Floats
    period: float | None = None

    def __post_init__(self) -> None:
        if self.stations.ndim != 1 or len(self.stations) < 3:
            raise GeometryError("differences need at least three stations")
        if not (self.gaps > 0.0).all():
            raise GeometryError("stations must increase, and end before the period")

    @property
    def gaps(self) -> Floats:
        """From each station to the next; S of them if periodic, else S - 1."""
        return station_gaps(self.stations, self.period)

    @property
    def even(self) -> bool:
        """Whether all gaps are equal, up to rounding."""
        gaps = self.gaps
        return bool(np.ptp(gaps) <= 1e-9 * gaps.max())

    def first(self, values: Floats) -> Floats:
        """d/ds of `values` (..., S)."""
        return self._apply(values, 1)

    def second(self, values: Floats) -> Floats:
        """d^2/ds^2 of `values` (..., S)."""
        return self._apply(values, 2)

    def _apply(self, values: Floats, order: int) -> Floats:
        result = np.empty(values.shape)
        before, here, after = values[..., :-2], values[..., 1:-1], values[..., 2:]
        inner = result[..., 1:-1]
        if self.even:
            _even(before, here, after, float(self.gaps[0]), order, inner)
        else:
            gaps = self.gaps
            count = len(self.stations) - 2
            _uneven(before, here, after, gaps[:count], gaps[1 : count + 1], order, inner)
        for end in (0, -1):
            result[..., end] = self._at_end(values, end, order)
        return result

    def _at_end(self, values: Floats, end: int, order: int) -> Floats:
        """The derivative at the first (0) or last (-1) station."""
        if self.period is not None:
            index = np.array([-1, 0, 1]) if end == 0 else np.array([-2, -1, 0])
            gaps = self.gaps[[-1, 0]] if end == 0 else self.gaps[[-2, -1]]
            offsets = np.array([-gaps[0], 0.0, gaps[1]])
        else:
            reach = np.arange(min(order + 2, len(self.stations)))
            index = reach if end == 0 else -1 - reach
            offsets = self.stations[index] - self.stations[end]
        return np.asarray(values[..., index] @ weights(offsets, order))


def station_gaps(stations: Floats, period: float | None) -> Floats:
    """From each station (S,) to the next; S of them with a `period`, else S - 1."""
    if period is None:
        return np.diff(stations)
    return np.diff(stations, append=stations[0] + period)


def weights(offsets: Floats, order: int) -> Floats:
    """Weights of the values at `offsets` that give the derivative of `order` at offset 0."""
    scale = np.abs(offsets).max()
    powers = np.vander(offsets / scale, increasing=True).T
    right = np.zeros(len(offsets))
    right[order] = math.factorial(order)
    return np.asarray(np.linalg.solve(powers, right) / scale**order)


def _even(before: Floats, here: Floats, after: Floats, gap: float, order: int, out: Floats) -> None:
    np.subtract(after, before, out=out) if order == 1 else np.add(after, before, out=out)
    if order == 2:
        out -= 2.0 * here
    out *= 1.0 / gap**2 if order == 2 else 0.5 / gap


def _uneven(
    before: Floats,
    here: Floats,
    after: Floats,
    gap: Floats,
    following: Floats,
    order: int,
    out: Floats,
) -> None:
    forward, backward = (after - here) / following, (here - before) / gap
    if order == 1:
        out[...] = (gap * forward + following * backward) / (gap + following)
    else:
        out[...] = 2.0 * (forward - backward) / (gap + following)
