"""Many curves at once, sampled at shared stations."""

from __future__ import annotations

from functools import cached_property
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arrays import Booleans, Floats, SharedArrays, cached_array, finite, norm, read_only
from ..curves.curve import Curve
from ..errors import GeometryError
from ..numbers.curvature import curvature_of_points
from ..numbers.differences import derivative, station_gaps
from .folding import fold_of_points
from .smooth_moves import StepBounds

Batch = TypeVar("Batch", bound="CurveBatch")
_COMPUTED = {
    "heading",
    "toward_east",
    "toward_north",
    "speed",
    "curvature",
    "steps",
    "folded",
    "slope",
}
"""Properties that are computed when they are first used, with a row for each variant."""


class CurveBatch(SharedArrays):
    """V curves, each sampled at the S `stations` (arc length of the root curve, meters).

    `points`: (V, S, 2). A closed batch does not repeat its first point; `period` is the root's
    length (by default one mean gap after the last station). Raises GeometryError for other shapes
    and for numbers that are not finite.
    """

    def __init__(
        self,
        stations: ArrayLike,
        points: ArrayLike,
        closed: bool = False,
        period: float | None = None,
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
        self._share()

    @cached_array
    def points(self) -> Floats:
        """(V, S, 2) meters."""
        return self._points

    @property
    def variants(self) -> int:
        """How many rows."""
        return int(self.points.shape[0])

    @cached_property
    def _velocity(self) -> tuple[Floats, Floats]:
        """(V, S) each: how x and y change along the stations."""
        along = np.moveaxis(self.points, -1, 0)
        dx, dy = derivative(along, self.stations, self.period)
        return dx, dy

    @cached_array
    def heading(self) -> Floats:
        """(V, S) radians, continuous along each curve."""
        dx, dy = self._velocity
        return np.unwrap(np.arctan2(dy, dx), axis=-1)

    def heading_of(self, rows: NDArray[Any]) -> Floats:
        """(n, S) that of some variants, by index; nothing else of these is computed or copied."""
        known: CurveBatch = self if "heading" in vars(self) else self.take(rows)
        return known.heading[rows] if known is self else known.heading

    @cached_array
    def toward_east(self) -> Floats:
        """(V, S) the part to the east of the unit vectors along the curves."""
        return np.cos(self.heading)

    @cached_array
    def toward_north(self) -> Floats:
        """(V, S) the part to the north of the unit vectors along the curves."""
        return np.sin(self.heading)

    @cached_array
    def speed(self) -> Floats:
        """(V, S) meters along the curve for a meter along the stations."""
        return np.hypot(*self._velocity)

    @cached_array
    def curvature(self) -> Floats:
        """(V, S) 1/m, left positive: of the circle through each point and its neighbors."""
        return curvature_of_points(self.points[..., 0], self.points[..., 1], self.closed)

    @property
    def normal(self) -> Floats:
        """(V, S, 2) unit vectors to the left."""
        normal = np.empty((*self.toward_north.shape, 2))
        np.negative(self.toward_north, out=normal[..., 0])
        normal[..., 1] = self.toward_east
        return normal

    @cached_array
    def steps(self) -> Floats:
        """(V, S - 1) meters from each point to the next; (V, S) if closed."""
        points = self.points
        if self.closed:
            points = np.concatenate([points, points[:, :1]], axis=1)
        return norm(np.diff(points, axis=1))

    @cached_property
    def step_bounds(self) -> StepBounds:
        """The steps, for quick tests: of its lines, and of those that are displaced from them."""
        return StepBounds.of(self.points, self.closed)

    @property
    def length(self) -> Floats:
        """(V,) meters along each curve."""
        return np.asarray(self.steps.sum(axis=1))

    @cached_array
    def folded(self) -> Booleans:
        """(V,) True where a curve turns by a quarter turn or more from one step to the next, or has
        a step of less than 5 % of the gap of its stations; see
        `roadlang.geometry.batches.folding`."""
        return fold_of_points(self.points, self.gaps, self.closed)

    @property
    def gaps(self) -> Floats:
        """Meters from each station to the next: S - 1 of them, S if closed."""
        return station_gaps(self.stations, self.period)

    def curve(self, variant: int) -> Curve:
        """One variant as a spline through its points."""
        return Curve.through(self.points[variant], self.closed)

    def take(self, variants: ArrayLike) -> CurveBatch:
        """The variants chosen by index or by mask."""
        rows = np.asarray(variants)
        return self._computed_for(
            CurveBatch(self.stations, self.points[rows], self.closed, self.period), rows
        )

    def _computed_for(self, batch: Batch, rows: NDArray[Any]) -> Batch:
        """Rows of this batch, with what was computed of them so far."""
        computed = vars(self)
        for name in _COMPUTED & computed.keys():
            vars(batch)[name] = read_only(computed[name][rows])
        return batch
