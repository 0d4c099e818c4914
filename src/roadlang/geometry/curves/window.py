"""Smooth windows over arc length: where a displacement acts, and how it fades out."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Floats
from ..errors import GeometryError


def over(
    stations: Floats, start: float, stop: float, taper: float = 0.0, period: float | None = None
) -> Floats:
    """(S,) one on [start, stop] but for the `taper` meters inside each end, zero elsewhere.

    An infinite end is not tapered. With a `period` the interval may cross the seam
    (`start > stop`). Raises GeometryError for a negative taper and for `start > stop` without one.
    """
    if taper < 0.0 or not np.isfinite(taper):
        raise GeometryError("a taper must be a length, zero or more")
    if period is not None and start > stop:
        width = stop + period - start
        stations = (stations - start) % period
        start, stop = 0.0, width
    if start > stop:
        raise GeometryError("an interval must not end before it starts")
    taper = min(taper, (stop - start) / 2.0)
    return _rise(stations, start, taper) * _rise(stations, stop, taper, falling=True)


def fade(
    stations: Floats, length: float, taper: float, at_start: bool = True, at_end: bool = True
) -> Floats:
    """(S,) zero at the chosen ends of an open curve of `length`, one from `taper` meters inside.

    Value, slope and second derivative vanish at the ends, so that position, heading and curvature
    stay there. When both ends fade and the curve is shorter than twice `taper`, each takes half and
    the window stays below one, so that nowhere it bends more than with room for the whole taper.
    """
    if not taper > 0.0:
        raise GeometryError("the taper of a fade must be positive")
    room = min(taper, length / 2.0) if at_start and at_end else taper
    window = np.full_like(stations, (room / taper) ** 2)
    if at_start:
        window = window * _rise(stations, 0.0, room)
    if at_end:
        window = window * _rise(stations, length, room, falling=True)
    return window


def ease(t: ArrayLike) -> Floats:
    """The quintic 6t^5 - 15t^4 + 10t^3 from 0 at t <= 0 to 1 at t >= 1.

    Its first and second derivatives vanish at both ends.
    """
    x = np.clip(np.asarray(t, dtype=np.float64), 0.0, 1.0)
    return np.minimum(x**3 * (10.0 - 15.0 * x + 6.0 * x * x), 1.0)


def _rise(stations: Floats, at: float, taper: float, falling: bool = False) -> Floats:
    """From 0 at `at` to 1 after `taper` meters; if `falling`, 0 at `at` and 1 before it."""
    distance = (at - stations) if falling else (stations - at)
    if taper <= 0.0 or not np.isfinite(at):
        return (distance >= 0.0).astype(np.float64)
    with np.errstate(over="ignore"):
        return ease(distance / taper)
