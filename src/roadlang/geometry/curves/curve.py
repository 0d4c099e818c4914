"""A smooth plane curve, parametrized by its arc length."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Floats, SharedArrays, cross, finite, finite_points, norm, wrapped
from ..errors import GeometryError
from .arclength import ArcLength
from .fitted_splines import fitted
from .projection import project
from .spline import PiecewiseCubic, frame_of, hermite

_SMALLEST_JUMP = 1e-6


@dataclass(frozen=True, eq=False)
class Curve(SharedArrays):
    """A piecewise cubic, with every quantity a function of arc length `s` in meters.

    Make one with `Curve.through(points)`, or of points with known headings `Curve.hermite`. Methods
    take a number or an array of arc lengths and return an array of its shape, with a last axis of
    two for points. Arc lengths beyond the ends of an open curve go straight on along its tangent;
    those of a closed curve go round.
    """

    spline: PiecewiseCubic
    closed: bool
    points: Floats
    """(n, 2) what the curve was made through; a closed curve does not repeat the first"""

    @classmethod
    def through(cls, points: ArrayLike, closed: bool = False) -> Curve:
        """The interpolating C2 cubic spline through `points` (n, 2), meters.

        Two points make a straight line; neighbors that coincide count once. The knots are
        refined until they are the arc lengths of the points. Raises GeometryError for points that
        are not finite, for fewer than two distinct ones, and for fewer than three if closed.
        """
        distinct = distinct_points(points, closed)
        return cls(fitted([distinct], closed)[0], closed, distinct)

    @classmethod
    def through_each(cls, rows: Sequence[ArrayLike]) -> list[Curve]:
        """The open curve through each row of points, as `through`, with its arc length known.

        Many roads of few points take a fraction of the time.
        """
        if not rows:
            return []
        distinct = [distinct_points(points, False) for points in rows]
        curves = [
            cls(spline, False, points)
            for spline, points in zip(fitted(distinct, False), distinct, strict=True)
        ]
        for curve, arc in zip(curves, ArcLength.of_each([c.spline for c in curves]), strict=True):
            vars(curve).update(arc=arc)  # where the property keeps it
        return curves

    @classmethod
    def hermite(cls, points: ArrayLike, headings: ArrayLike, closed: bool = False) -> Curve:
        """The cubic through `points` (n, 2) with exactly the `headings` (n,), radians.

        For points of known heading (arcs, clothoids): no ringing where the curvature jumps. Raises
        GeometryError as `through` does, and for neighbors that coincide.
        """
        samples = finite_points(points)
        angles = finite(headings, "the headings of a curve")
        if angles.shape != (len(samples),):
            raise GeometryError("a curve needs one heading for each of its points")
        if len(distinct_points(samples, closed)) != len(samples):
            raise GeometryError("neighboring points of a curve with headings must differ")
        return cls(hermite(samples, angles, closed), closed, samples)

    @cached_property
    def arc(self) -> ArcLength:
        """Arc length as a function of the spline's parameter."""
        return ArcLength.of(self.spline)

    @property
    def length(self) -> float:
        """Meters along the curve; once round if closed."""
        return self.arc.total

    def at(self, s: ArrayLike) -> Floats:
        """(..., 2) points at arc lengths `s`; exactly the end point at `length`."""
        return self._points(self._places(s))

    def tangent(self, s: ArrayLike) -> Floats:
        """(..., 2) unit vectors along the curve."""
        return frame_of(self._places(s).derivatives[0])[0]

    def normal(self, s: ArrayLike) -> Floats:
        """(..., 2) unit vectors to the left of the curve."""
        return frame_of(self._places(s).derivatives[0])[1]

    def heading(self, s: ArrayLike) -> Floats:
        """Radians counter-clockwise from east, continuous along the curve, in (-pi, pi] at 0."""
        return self._heading(self._places(s))

    def curvature(self, s: ArrayLike) -> Floats:
        """1/m, positive where the curve bends left; zero beyond the ends."""
        return self.bending(s)[0]

    def bending(self, s: ArrayLike) -> tuple[Floats, Floats]:
        """The curvature (1/m) and its derivative by arc length (1/m^2), between its jumps."""
        return self._bending(self._places(s))

    def pose_and_bending(self, s: ArrayLike) -> tuple[Floats, Floats, Floats, Floats]:
        """What `at`, `heading` and `bending` give, for less: the places are found once."""
        places = self._places(s)
        return self._points(places), self._heading(places), *self._bending(places)

    def curvature_jumps(self) -> tuple[Floats, Floats]:
        """Arc lengths (n,) where the curvature jumps, and by how much, 1/m (n,).

        None on a spline through points; where pieces of different curvature meet on others.
        """
        after, before = self.spline.knot_curvatures(self.closed)
        jumps = after - before
        real = np.abs(jumps) > _SMALLEST_JUMP
        knots = self.spline.knots[:-1] if self.closed else self.spline.knots[1:-1]
        return self.arc.length_at(knots[real]), jumps[real]

    def stations(self, spacing: float | None = None, count: int | None = None) -> Floats:
        """Even arc lengths: `count` of them, or as many as keep them at most `spacing` apart.

        An open curve's include both ends; a closed curve's leave out the repeated start.
        """
        if (spacing is None) == (count is None):
            raise GeometryError("stations need either a spacing or a count")
        if spacing is not None:
            if not spacing > 0.0:
                raise GeometryError("the spacing of stations must be positive")
            gaps = max(1, int(np.ceil(self.length / spacing - 1e-9)))
            count = max(gaps, 3) if self.closed else gaps + 1
        assert count is not None
        if count < 2:
            raise GeometryError("a curve needs at least two stations")
        return np.linspace(0.0, self.length, count, endpoint=not self.closed)

    def project(self, points: ArrayLike) -> tuple[Floats, Floats]:
        """Arc length of the nearest point of the curve, and the lateral offset (left positive).

        Both (...,) for points (..., 2). Beside an end of an open curve the offset is measured
        across the tangent there, so it leaves out how far beyond the end the point lies.
        """
        return project(self.arc, self.closed, points)

    def between(self, start: float, stop: float) -> Curve:
        """The part from arc length `start` to `stop`, exactly; round the seam if closed.

        Raises GeometryError where nothing of the curve is between them.
        """
        length = self.length
        if self.closed and start != stop:
            start %= length
            stop = stop % length
            stop += length if stop <= start else 0.0
        elif not self.closed:
            start, stop = max(start, 0.0), min(stop, length)
        if not stop - start > 1e-9 * length:
            raise GeometryError("part of a curve must have a positive length")
        ends = self.arc.parameter(np.array([start, min(stop, length)]))
        if stop > length:
            lap = float(self.spline.knots[-1])
            ends[1] = lap + float(self.arc.parameter(np.array([stop - length]))[0])
        source = self.spline.repeated() if self.closed else self.spline
        spline = source.between(float(ends[0]), float(ends[1]))
        points = np.concatenate([spline.coefficients[:, 0], self.at(np.array([stop]))])
        return Curve(spline, False, points)

    def reversed(self) -> Curve:
        """The same curve from end to start."""
        points = self.points[::-1]
        return Curve(
            self.spline.reversed(),
            self.closed,
            np.roll(points, 1, axis=0) if self.closed else points,
        )

    def resampled(self, spacing: float | None = None, count: int | None = None) -> Curve:
        """A new spline through even stations of this curve."""
        return Curve.through(self.at(self.stations(spacing, count)), self.closed)

    def transformed(self, matrix: ArrayLike, shift: ArrayLike = (0.0, 0.0)) -> Curve:
        """Each point p becomes `matrix @ p + shift`; a mirror swaps left and right."""
        linear = finite(matrix, "the matrix").reshape(2, 2)
        offset = finite(shift, "the shift").reshape(2)
        if abs(np.linalg.det(linear)) <= 0.0:
            raise GeometryError("the matrix must not flatten the plane")
        spline = self.spline.transformed(linear, offset)
        return Curve(spline, self.closed, self.points @ linear.T + offset)

    def scaled(self, factor: float) -> Curve:
        """All lengths times `factor`: pixels to meters, for one."""
        return self.transformed(np.eye(2) * factor)

    @cached_property
    def _headings(self) -> Floats:
        """Continuous heading at the parameters of the arc table."""
        first = self.spline.derivatives(self.arc.parameters)[0]
        return np.unwrap(np.arctan2(first[:, 1], first[:, 0]))

    def _points(self, places: _Places) -> Floats:
        points = self.spline.position(places.parameter)
        if not self.closed:
            last = places.s == self.length
            points = np.where(last[..., None], self.points[-1], points)
        if places.beyond.any():
            tangent, _ = frame_of(places.derivatives[0])
            points = points + places.beyond[..., None] * tangent
        return points

    def _heading(self, places: _Places) -> Floats:
        first, parameters = places.derivatives[0], self.arc.parameters
        near = self._headings[np.searchsorted(parameters, places.parameter, side="right") - 1]
        turned = near + wrapped(np.arctan2(first[..., 1], first[..., 0]) - near)
        return np.asarray(turned + places.laps * (self._headings[-1] - self._headings[0]))

    def _bending(self, places: _Places) -> tuple[Floats, Floats]:
        first, second, third = places.derivatives
        speed = np.maximum(np.hypot(first[..., 0], first[..., 1]), 1e-9)
        curvature = cross(first, second) / speed**3
        along = (first * second).sum(axis=-1) / speed**2
        change = (cross(first, third) / speed**3 - 3.0 * curvature * along) / speed
        inside = np.abs(places.beyond) <= 1e-9 * self.length
        return np.where(inside, curvature, 0.0), np.where(inside, change, 0.0)

    def _places(self, s: ArrayLike) -> _Places:
        stations = finite(s, "arc lengths")
        laps = np.floor(stations / self.length) if self.closed else np.zeros_like(stations)
        inside = np.clip(stations - laps * self.length, 0.0, self.length)
        beyond = np.zeros_like(stations) if self.closed else stations - inside
        return _Places(self.spline, stations, self.arc.parameter(inside), beyond, laps)


@dataclass(frozen=True, eq=False)
class _Places:
    """Where arc lengths `s` are on a spline: its parameter there, the meters beyond an end of the
    curve (signed), and whole laps."""

    spline: PiecewiseCubic
    s: Floats
    parameter: Floats
    beyond: Floats
    laps: Floats

    @cached_property
    def derivatives(self) -> tuple[Floats, Floats, Floats]:
        """The first three by the parameter."""
        return self.spline.derivatives(self.parameter)


def distinct_points(points: ArrayLike, closed: bool) -> Floats:
    """`points` without repeats of a neighbor; raises GeometryError when too few are left."""
    array = finite_points(points)
    if len(array):
        extent = float(norm(np.ptp(array, axis=0)))
        tolerance = max(
            1e-9 * extent, 8.0 * np.finfo(float).eps * float(np.abs(array).max()), 1e-12
        )
        array = _without_repeats(array, tolerance)
        if closed and len(array) > 1 and norm(array[0] - array[-1]) <= tolerance:
            array = array[:-1]
    needed = 3 if closed else 2
    if len(array) < needed:
        kind = "a closed curve" if closed else "a curve"
        raise GeometryError(f"{kind} needs at least {needed} distinct points, not {len(array)}")
    return array


def _without_repeats(array: Floats, tolerance: float) -> Floats:
    """Keeps the first of points that coincide, but of those at the end the last."""
    keep = np.ones(len(array), dtype=bool)
    keep[1:] = norm(array[1:] - array[:-1]) > tolerance
    distinct = np.array(array[keep])
    if len(distinct) > 1:
        distinct[-1] = array[-1]
    return distinct
