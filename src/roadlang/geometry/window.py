"""Smooth windows over arc length: where a displacement acts, and how it fades out."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .arrays import Floats, SharedArrays
from .errors import GeometryError


@dataclass(frozen=True, eq=False)
class Window(SharedArrays):
    """A factor in [0, 1] at stations (S,), twice continuously differentiable, and derivatives."""

    value: Floats
    slope: Floats
    bend: Floats

    def apply(
        self, displacement: Floats, slope: Floats | None = None, bend: Floats | None = None
    ) -> tuple[Floats, Floats | None, Floats | None]:
        """The displacement (V, S) in this window, with its derivatives where they were given."""
        windowed = self.value * displacement
        if slope is None:
            return windowed, None, None
        first = self.slope * displacement + self.value * slope
        if bend is None:
            return windowed, first, None
        second = self.bend * displacement + 2.0 * self.slope * slope + self.value * bend
        return windowed, first, second

    def __mul__(self, other: Window) -> Window:
        value, slope, bend = self.apply(other.value, other.slope, other.bend)
        assert slope is not None
        assert bend is not None
        return Window(value, slope, bend)


def over(
    stations: Floats, start: float, stop: float, taper: float = 0.0, period: float | None = None
) -> Window:
    """One on [start, stop] but for the `taper` meters inside each end, zero elsewhere.

    An infinite end is not tapered. With a `period` the stretch may cross the seam
    (`start > stop`).
    """
    if taper < 0.0 or not np.isfinite(taper):
        raise GeometryError("a taper must be a length, zero or more")
    if period is not None and start > stop:
        width = stop + period - start
        stations = (stations - start) % period
        start, stop = 0.0, width
    if start > stop:
        raise GeometryError("a stretch must not end before it starts")
    reach = min(taper, (stop - start) / 2.0)
    return _rise(stations, start, reach) * _rise(stations, stop, reach, falling=True)


def fade(
    stations: Floats, length: float, reach: float, at_start: bool = True, at_end: bool = True
) -> Window:
    """Zero at the chosen ends of an open curve, one from `reach` meters inside.

    Value, slope and bend vanish at the ends, so position, heading and curvature stay there. When
    both ends fade and the curve is shorter than twice `reach`, each takes its half.
    """
    if not reach > 0.0:
        raise GeometryError("the reach of a fade must be positive")
    reach = min(reach, length / 2.0 if at_start and at_end else length)
    window = Window(np.ones_like(stations), np.zeros_like(stations), np.zeros_like(stations))
    if at_start:
        window = window * _rise(stations, 0.0, reach)
    if at_end:
        window = window * _rise(stations, length, reach, falling=True)
    return window


def ease(t: ArrayLike) -> tuple[Floats, Floats, Floats]:
    """The quintic 6t^5 - 15t^4 + 10t^3 from 0 at t <= 0 to 1 at t >= 1, and two derivatives."""
    x = np.clip(np.asarray(t, dtype=np.float64), 0.0, 1.0)
    y = 1.0 - x
    value = np.minimum(x**3 * (10.0 - 15.0 * x + 6.0 * x * x), 1.0)
    return value, 30.0 * x * x * y * y, 60.0 * x * y * (y - x)


def _rise(stations: Floats, at: float, reach: float, falling: bool = False) -> Window:
    """From 0 at `at` to 1 after `reach` meters; if `falling`, 0 at `at` and 1 before it."""
    sign = -1.0 if falling else 1.0
    distance = sign * (stations - at)
    if reach <= 0.0 or not np.isfinite(at):
        flat = np.zeros_like(stations)
        return Window((distance >= 0.0).astype(np.float64), flat, flat)
    value, slope, bend = ease(distance / reach)
    return Window(value, sign * slope / reach, bend / reach**2)
