"""The width of a road along its arc length."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Floats, SharedArrays, finite
from ..errors import GeometryError
from .profile import checked_profile


@dataclass(frozen=True, eq=False)
class WidthProfile(SharedArrays):
    """Widths (n,) at increasing `stations` (n,), meters; linear between, constant beyond.

    With a `period` (closed roads) the last width runs linearly on to the first. A lane may taper
    to nothing; the width of a road must be positive everywhere, which `Road` and `Edge` check.
    """

    stations: Floats
    widths: Floats
    period: float | None = None

    def __post_init__(self) -> None:
        stations, widths = checked_profile(self.stations, self.widths, "widths")
        if not (widths >= 0.0).all() or not widths.any():
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

    def scaled(self, factor: float, width_factor: float | None = None) -> WidthProfile:
        """Arc lengths times `factor`, widths times `width_factor` or, by default, the same."""
        period = None if self.period is None else self.period * factor
        widths = self.widths * (factor if width_factor is None else width_factor)
        return WidthProfile(self.stations * factor, widths, period)

    def reversed(self, length: float) -> WidthProfile:
        """As met along the road of this length traveled the other way."""
        return WidthProfile(length - self.stations[::-1], self.widths[::-1], self.period)

    def require_positive(self) -> None:
        """Raises GeometryError where the width is zero."""
        if not (self.widths > 0.0).all():
            raise GeometryError("a width must be positive")
