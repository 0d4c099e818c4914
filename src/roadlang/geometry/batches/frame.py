"""A curve's Frenet frame at fixed stations: what displacing it needs, computed once."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Floats, SharedArrays, finite
from ..curves.curve import Curve
from ..errors import GeometryError
from ..numbers.differences import Differences, station_gaps
from .folding import BaseSteps


@dataclass(frozen=True, eq=False)
class CurveFrame(SharedArrays):
    """`stations` (S,) of a curve, and its points, headings and curvatures there; make one with
    `CurveFrame.of`."""

    curve: Curve
    stations: Floats
    points: Floats
    """(S, 2) meters"""
    heading: Floats
    """(S,) radians, continuous"""
    curvature: Floats
    """(S,) 1/m, left positive"""
    curvature_slope: Floats
    """(S,) 1/m^2, its derivative by arc length; a jump counts at the two stations beside it"""

    @classmethod
    def of(cls, curve: Curve, stations: ArrayLike) -> CurveFrame:
        """The frame at increasing arc lengths."""
        s = finite(stations, "stations")
        if s.ndim != 1 or len(s) < 2 or not (np.diff(s) > 0.0).all():
            raise GeometryError("stations must be at least two increasing arc lengths")
        points, heading, curvature, slope = curve.pose_and_bending(s)
        slope = slope + _spread(*curve.curvature_jumps(), s, curve)
        return cls(curve, s, points, heading, curvature, slope)

    @property
    def closed(self) -> bool:
        """Whether the curve ends where it begins."""
        return self.curve.closed

    @property
    def period(self) -> float | None:
        """Meters round, of a closed curve."""
        return self.curve.length if self.curve.closed else None

    @property
    def normal(self) -> Floats:
        """(S, 2) unit vectors to the left."""
        return np.stack([-np.sin(self.heading), np.cos(self.heading)], axis=-1)

    @cached_property
    def differences(self) -> Differences:
        """Derivatives along the stations. Raises GeometryError for fewer than three."""
        return Differences(self.stations, self.period)

    @cached_property
    def steps(self) -> BaseSteps:
        """The steps from station to station: they tell whether a displacement folds the road."""
        gaps = station_gaps(self.stations, self.period)
        bending = self.curvature, self.curvature_slope
        return BaseSteps.of(self.points, self.normal, bending, gaps, self.closed)

    def same_as(self, other: CurveFrame) -> bool:
        """Whether displacements along both can be compared number by number."""
        return self.curve is other.curve and np.array_equal(self.stations, other.stations)


def _spread(places: Floats, jumps: Floats, stations: Floats, curve: Curve) -> Floats:
    """(S,) what the derivative of steps of height `jumps` is at the stations: each step counts at
    the two stations beside it, by how near they are, so that its integral is the step."""
    slope = np.zeros(len(stations))
    if len(jumps) == 0:
        return slope
    period = curve.length if curve.closed else None
    gaps = station_gaps(stations, period)
    offset = places - stations[0]
    offset = np.mod(offset, period) if period is not None else offset
    left = np.searchsorted(stations - stations[0], offset, side="right") - 1
    inside = (left >= 0) & (left < len(gaps)) & (offset >= 0.0)
    left, offset, jumps = left[inside], offset[inside], jumps[inside]
    share = (offset - (stations[left] - stations[0])) / gaps[left]
    np.add.at(slope, left, jumps * (1.0 - share) / gaps[left])
    np.add.at(slope, (left + 1) % len(stations), jumps * share / gaps[left])
    return slope
