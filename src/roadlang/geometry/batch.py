"""Many variants of one curve at once, sampled at shared stations."""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from .arrays import (
    Booleans,
    Floats,
    SharedArrays,
    cached_array,
    cross,
    finite,
    left_of,
    norm,
    wrapped,
)
from .curve import Curve
from .differences import Stencil, station_gaps
from .displacement import turned_curvature
from .errors import GeometryError
from .folding import fold_of_points
from .frame import Frame


class CurveBatch(SharedArrays):
    """V curves, each sampled at the S `stations` (arc length of the root curve, meters).

    `points`: (V, S, 2). A closed batch does not repeat its first point; `period` is the root's
    length (by default one mean gap after the last station). `base`: the batch that was displaced to
    make this one, of V rows or one.
    """

    def __init__(
        self,
        stations: ArrayLike,
        points: ArrayLike,
        closed: bool = False,
        period: float | None = None,
        base: CurveBatch | None = None,
    ) -> None:
        self.stations = finite(stations, "stations")
        self._points = finite(points, "the points of a batch")
        self.closed = closed
        count = len(self.stations)
        if self._points.ndim != 3 or self._points.shape[1:] != (count, 2):
            raise GeometryError(
                f"a batch at {count} stations needs points of shape (V, {count}, 2)"
            )
        if closed and period is None:
            first, last = float(self.stations[0]), float(self.stations[-1])
            period = (last - first) * count / max(count - 1, 1)
        self.period = period if closed else None
        self._base = base
        self._share()

    @cached_array
    def points(self) -> Floats:
        """(V, S, 2) meters."""
        return self._points

    @property
    def variants(self) -> int:
        """Number of curves, V."""
        return int(self.points.shape[0])

    @cached_property
    def _derivatives(self) -> tuple[Floats, Floats]:
        stencil = Stencil(self.stations, self.period)
        along = np.moveaxis(self.points, -1, 0)
        return np.moveaxis(stencil.first(along), 0, -1), np.moveaxis(stencil.second(along), 0, -1)

    @cached_array
    def heading(self) -> Floats:
        """(V, S) radians, continuous along each curve."""
        first = self._derivatives[0]
        return np.unwrap(np.arctan2(first[..., 1], first[..., 0]), axis=-1)

    @cached_array
    def curvature(self) -> Floats:
        """(V, S) 1/m, left positive; second order in the gap of the stations."""
        first, second = self._derivatives
        speed = np.maximum(np.hypot(first[..., 0], first[..., 1]), 1e-9)
        return np.asarray(cross(first, second) / speed**3)

    @property
    def normal(self) -> Floats:
        """(V, S, 2) unit vectors to the left."""
        return np.stack([-np.sin(self.heading), np.cos(self.heading)], axis=-1)

    @cached_array
    def steps(self) -> Floats:
        """(V, S - 1) meters from each point to the next; (V, S) if closed."""
        points = self.points
        if self.closed:
            points = np.concatenate([points, points[:, :1]], axis=1)
        return norm(np.diff(points, axis=1))

    @property
    def length(self) -> Floats:
        """(V,) meters along each curve."""
        return np.asarray(self.steps.sum(axis=1))

    @cached_array
    def folded(self) -> Booleans:
        """(V,) True where a curve runs backwards, turns by a quarter turn from one step to the
        next, or has a step of less than 5 % of its gap; see `roadlang.geometry.folding`."""
        gaps = station_gaps(self.stations, self.period)
        if self._base is None:
            return fold_of_points(self.points, gaps, self.closed)
        again = fold_of_points(self.points, gaps, self.closed, self._base.points)
        return again | self._base.folded

    def curve(self, variant: int) -> Curve:
        """One variant as a spline through its points."""
        return Curve.through(self.points[variant], self.closed)

    def take(self, variants: ArrayLike) -> CurveBatch:
        """The variants chosen by index or by mask."""
        chosen = np.asarray(variants)
        base = self._base
        if base is not None and base.variants > 1:
            base = base.take(chosen)
        return CurveBatch(self.stations, self.points[chosen], self.closed, self.period, base)


class DisplacedBatch(CurveBatch):
    """One curve displaced in V ways along its normal: `points + displacement * normal`.

    Everything is computed from the frame and the displacement when it is first asked for;
    `slope` and `bend` (V, S) are the derivatives of the displacement by arc length.
    """

    def __init__(
        self, frame: Frame, displacement: Floats, slope: Floats | None, bend: Floats | None
    ) -> None:
        self.frame = frame
        self.stations = frame.stations
        self.closed = frame.closed
        self.period = frame.period
        self.displacement = displacement
        self._slope = slope
        self._bend = bend
        self._share()

    @property
    def variants(self) -> int:
        """Number of curves, V."""
        return int(self.displacement.shape[0])

    @cached_array
    def points(self) -> Floats:
        """Displaced points in meters, (V, S, 2)."""
        points = np.empty((*self.displacement.shape, 2))
        normal = self.frame.normal
        for axis in (0, 1):
            np.multiply(self.displacement, normal[:, axis], out=points[..., axis])
            points[..., axis] += self.frame.points[:, axis]
        return points

    @cached_array
    def slope(self) -> Floats:
        """(V, S) d(displacement)/ds."""
        if self._slope is not None:
            return self._slope
        return Stencil(self.stations, self.period).first(self.displacement)

    @cached_array
    def bend(self) -> Floats:
        """(V, S) d^2(displacement)/ds^2, 1/m."""
        if self._bend is not None:
            return self._bend
        if self._slope is not None:
            return Stencil(self.stations, self.period).first(self._slope)
        return Stencil(self.stations, self.period).second(self.displacement)

    @cached_array
    def heading(self) -> Floats:
        """Heading in radians, (V, S)."""
        progress = 1.0 - self.frame.curvature * self.displacement
        return np.asarray(self.frame.heading + np.arctan2(self.slope, progress))

    @cached_array
    def curvature(self) -> Floats:
        """Signed curvature in 1/m, (V, S)."""
        return turned_curvature(
            self.displacement,
            self.slope,
            self.bend,
            self.frame.curvature,
            self.frame.curvature_slope,
        )

    @cached_array
    def folded(self) -> Booleans:
        """(V,) True where the displacement comes near the center of a bend, or the road turns by a
        quarter turn from one step to the next; see `roadlang.geometry.folding`."""
        return self.frame.steps.folded(self.displacement)

    def take(self, variants: ArrayLike) -> DisplacedBatch:
        """The chosen variants; `variants` are indices or a Boolean mask."""
        chosen = np.asarray(variants)
        slope = None if self._slope is None else self._slope[chosen]
        bend = None if self._bend is None else self._bend[chosen]
        return DisplacedBatch(self.frame, self.displacement[chosen], slope, bend)


def displace(
    base: Curve | Frame | CurveBatch,
    stations: ArrayLike,
    displacement: ArrayLike,
    slope: ArrayLike | None = None,
    bend: ArrayLike | None = None,
) -> CurveBatch:
    """`base` moved along its left normal by `displacement` (V, S) or (S,), meters.

    With the derivatives `slope` and `bend` of the displacement by arc length the headings and
    curvatures are exact, else second order in the gap of the stations. A `Frame` as base saves
    computing it again (its own stations count then); a batch is displaced variant by variant.
    """
    if isinstance(base, CurveBatch):
        moves = _rows(displacement, len(base.stations), "a displacement")
        points = base.points + moves[..., None] * left_of(_tangents(base.heading))
        return CurveBatch(base.stations, points, base.closed, base.period, base)
    frame = base if isinstance(base, Frame) else Frame.of(base, stations)
    count = len(frame.stations)
    moves = _rows(displacement, count, "a displacement")
    return DisplacedBatch(
        frame,
        moves,
        None if slope is None else _like(slope, moves, "the slope"),
        None if bend is None else _like(bend, moves, "the bend"),
    )


def sample(curve: Curve, stations: ArrayLike) -> DisplacedBatch:
    """The curve itself as a batch of one."""
    frame = Frame.of(curve, stations)
    still = np.zeros((1, len(frame.stations)))
    return DisplacedBatch(frame, still, still, still)


def heading_error(a: CurveBatch, b: CurveBatch) -> Floats:
    """(V, S) heading of `a` against that of `b`, in [-pi, pi)."""
    return wrapped(a.heading - b.heading)


def _rows(values: ArrayLike, count: int, what: str) -> Floats:
    rows = np.atleast_2d(finite(values, what))
    if rows.ndim != 2 or rows.shape[1] != count:
        raise GeometryError(f"{what} at {count} stations must have the shape (V, {count})")
    return rows


def _like(values: ArrayLike, moves: Floats, what: str) -> Floats:
    rows = _rows(values, moves.shape[1], what)
    return rows if rows.shape == moves.shape else np.broadcast_to(rows, moves.shape)


def _tangents(heading: Floats) -> Floats:
    return np.stack([np.cos(heading), np.sin(heading)], axis=-1)
