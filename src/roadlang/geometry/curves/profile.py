"""Numbers along the arc length of a road: linear between stations, constant beyond them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Floats, SharedArrays, finite
from ..errors import GeometryError


def checked_profile(stations: ArrayLike, values: ArrayLike, what: str) -> tuple[Floats, Floats]:
    """Both as (n,) arrays. Raises GeometryError unless the stations increase and fit the values.

    `what` is plural: "widths".
    """
    s = finite(stations, f"the stations of {what}").reshape(-1)
    v = finite(values, what).reshape(-1)
    if len(s) == 0 or len(s) != len(v):
        raise GeometryError(f"a profile of {what} needs as many {what} as stations")
    if not (np.diff(s) > 0.0).all():
        raise GeometryError(f"the stations of {what} must increase")
    return s, v


@dataclass(frozen=True, eq=False)
class OffsetProfile(SharedArrays):
    """Lateral offsets (n,), left positive, at increasing `stations` (n,), all in meters.

    Linear between, constant beyond. With a `period` (closed roads) the last runs on to the first.
    Raises GeometryError for numbers that are not finite or stations that do not increase.
    """

    stations: Floats
    offsets: Floats
    period: float | None = None

    def __post_init__(self) -> None:
        stations, offsets = checked_profile(self.stations, self.offsets, "offsets")
        object.__setattr__(self, "stations", stations)
        object.__setattr__(self, "offsets", offsets)
        super().__post_init__()

    @classmethod
    def constant(cls, offset: float) -> OffsetProfile:
        """The same offset everywhere, in meters."""
        return cls(np.zeros(1), np.array([offset]))

    def at(self, s: ArrayLike) -> Floats:
        """The offset at each arc length."""
        at = np.asarray(s, dtype=np.float64)
        return np.interp(at, self.stations, self.offsets, period=self.period)

    def scaled(self, factor: float, offset_factor: float | None = None) -> OffsetProfile:
        """Arc lengths times `factor`, offsets times `offset_factor` or, by default, the same."""
        period = None if self.period is None else self.period * factor
        offsets = self.offsets * (factor if offset_factor is None else offset_factor)
        return OffsetProfile(self.stations * factor, offsets, period)

    def mirrored(self) -> OffsetProfile:
        """To the other side."""
        return OffsetProfile(self.stations, -self.offsets, self.period)

    def reversed(self, length: float) -> OffsetProfile:
        """As met along the road of this length traveled the other way, where left is right."""
        stations = length - self.stations[::-1]
        return OffsetProfile(stations, -self.offsets[::-1], self.period)
