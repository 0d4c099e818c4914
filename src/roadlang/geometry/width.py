"""The width of a road along its arc length."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .arrays import Floats, SharedArrays, finite
from .errors import GeometryError


@dataclass(frozen=True, eq=False)
class WidthProfile(SharedArrays):
    """Widths (n,) at increasing `stations` (n,), meters; linear between, constant beyond.

    With a `period` (closed roads) the last width runs linearly on to the first.
    """

    stations: Floats
    widths: Floats
    period: float | None = None

    def __post_init__(self) -> None:
        stations = finite(self.stations, "the stations of a width").reshape(-1)
        widths = finite(self.widths, "widths").reshape(-1)
        if len(stations) == 0 or len(stations) != len(widths):
            raise GeometryError("a width profile needs as many widths as stations")
        if not (np.diff(stations) > 0.0).all():
            raise GeometryError("the stations of a width profile must increase")
        if not (widths > 0.0).all():
            raise GeometryError("a width must be positive")
        object.__setattr__(self, "stations", stations)
        object.__setattr__(self, "widths", widths)
        super().__post_init__()

    @classmethod
    def constant(cls, width: float) -> WidthProfile:
        """The same width everywhere, in meters."""
        return cls(np.zeros(1), np.array([width]))

    @classmethod
    def even(cls, widths: ArrayLike, length: float, closed: bool = False) -> WidthProfile:
        """Widths at even stations: from 0 to `length`, or once round without the repeated start."""
        values = finite(widths, "widths").reshape(-1)
        stations = np.linspace(0.0, length, len(values), endpoint=not closed)
        return cls(stations, values, length if closed else None)

    def at(self, s: ArrayLike) -> Floats:
        """The width at each arc length."""
        return np.interp(
            np.asarray(s, dtype=np.float64), self.stations, self.widths, period=self.period
        )

    def scaled(self, factor: float) -> WidthProfile:
        """All lengths times `factor`."""
        period = None if self.period is None else self.period * factor
        return WidthProfile(self.stations * factor, self.widths * factor, period)
