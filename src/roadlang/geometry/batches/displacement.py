"""Curves displaced in many ways at once.

A curve `r(s)` with unit tangent `t`, left normal `n`, speed `v = |r'|` and curvature `k` that is
displaced by `d(s)` has the velocity `f t + g n` with `f = v + d' t` and `g = d' n`. Hence its speed
is `w = hypot(f, g)`, its heading turns by `atan2(g, f)` and its curvature is
`(v k + (f g' - g f') / w^2) / w`. Of a displacement `d = e n` along the normal, `f = v (1 - k e)`
and `g = e'`. Derivatives of displacements are second-order differences, so that what is computed
here is accurate to second order in the gap of the stations.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Booleans, Floats, cached_array, finite
from ..curves.curve import Curve
from ..errors import GeometryError
from ..numbers.differences import derivative
from .batch import CurveBatch
from .displaced_curvature import displaced_curvature
from .folding import turns_too_much
from .frame import CurveFrame
from .moved_batch import MovedBatch, size_of, turned
from .pushed_batch import pushed


class DisplacedBatch(CurveBatch):
    """One curve displaced in V ways along its normal: `points + displacement * normal`.

    Everything is computed from the frame and the displacement when it is first needed.
    """

    def __init__(self, frame: CurveFrame, displacement: Floats) -> None:
        self.frame = frame
        self.stations = frame.stations
        self.closed = frame.closed
        self.period = frame.period
        self.displacement = displacement
        self._share()

    @property
    def variants(self) -> int:
        """How many rows."""
        return int(self.displacement.shape[0])

    @cached_array
    def points(self) -> Floats:
        """(V, S, 2) meters."""
        points = np.empty((*self.displacement.shape, 2))
        for axis in (0, 1):
            np.multiply(self.displacement, self.frame.normal[:, axis], out=points[..., axis])
            points[..., axis] += self.frame.points[:, axis]
        return points

    @cached_array
    def slope(self) -> Floats:
        """(V, S) d(displacement)/ds."""
        return self.frame.differences.derivative(self.displacement)

    @cached_array
    def heading(self) -> Floats:
        """(V, S) radians, continuous along each curve."""
        progress = 1.0 - self.frame.curvature * self.displacement
        return np.asarray(self.frame.heading + np.arctan2(self.slope, progress))

    @cached_array
    def toward_east(self) -> Floats:
        """(V, S) the part to the east of the unit vectors along the curves."""
        _, along = self.frame.normal.T
        return self._turned(along, self.frame.normal[:, 0])

    @cached_array
    def toward_north(self) -> Floats:
        """(V, S) the part to the north of the unit vectors along the curves."""
        across, along = self.frame.normal.T
        return self._turned(-across, along)

    def _turned(self, straight: Floats, left: Floats) -> Floats:
        progress = 1.0 - self.frame.curvature * self.displacement
        return turned((straight, left), (progress, self.slope), self.speed)

    @cached_array
    def speed(self) -> Floats:
        """(V, S) meters along the curve for a meter along the stations."""
        return size_of(1.0 - self.frame.curvature * self.displacement, self.slope)

    @cached_array
    def curvature(self) -> Floats:
        """(V, S) 1/m, left positive."""
        frame = self.frame
        return displaced_curvature(
            self.displacement, frame.differences, frame.curvature, frame.curvature_slope
        )

    @cached_array
    def folded(self) -> Booleans:
        """(V,) True where a curve runs backwards or turns by a quarter turn from one station to the
        next; see `roadlang.geometry.batches.folding`."""
        surely_smooth = self.frame.steps.surely_smooth(self.displacement)
        folded = ~surely_smooth
        if folded.any():
            doubtful = self.take(folded)
            folded[folded] = self.frame.steps.folded(doubtful.displacement) | turns_too_much(
                doubtful.curvature, doubtful.steps, self.closed
            )
        return folded

    def take(self, variants: ArrayLike) -> DisplacedBatch:
        """The variants chosen by index or by mask."""
        rows = np.asarray(variants)
        return self._computed_for(DisplacedBatch(self.frame, self.displacement[rows]), rows)


def displace(
    base: Curve | CurveFrame | CurveBatch, stations: ArrayLike, displacement: ArrayLike
) -> CurveBatch:
    """`base` moved by `displacement`, meters: along its left normal, (V, S) or (S,), or east and
    north, (V, S, 2).

    A `CurveFrame` as base saves computing it again (its own stations count then); a batch is
    displaced variant by variant. Raises GeometryError for other shapes and for numbers that are not
    finite.
    """
    if isinstance(base, Curve):
        base = CurveFrame.of(base, stations)
    meters = finite(displacement, "a displacement")
    _check_shape(meters, len(base.stations))
    if meters.ndim == 3:
        return _shifted(undisplaced(base) if isinstance(base, CurveFrame) else base, meters)
    meters = np.atleast_2d(meters)
    return DisplacedBatch(base, meters) if isinstance(base, CurveFrame) else pushed(base, meters)


def sample(curve: Curve, stations: ArrayLike) -> DisplacedBatch:
    """The curve itself as a batch of one."""
    return undisplaced(CurveFrame.of(curve, stations))


def undisplaced(frame: CurveFrame) -> DisplacedBatch:
    """The curve of a frame itself as a batch of one."""
    return DisplacedBatch(frame, np.zeros((1, len(frame.stations))))


def _shifted(base: CurveBatch, shift: Floats) -> MovedBatch:
    """In the plane: the new line need not go where the old one went."""
    along = derivative(np.moveaxis(shift, -1, 0), base.stations, base.period)
    change = np.moveaxis(along, 0, -1)
    tangent = np.stack([base.normal[..., 1], -base.normal[..., 0]], axis=-1)
    forward = base.speed + (change * tangent).sum(axis=-1)
    sideways = (change * base.normal).sum(axis=-1)
    return MovedBatch(base, base.points + shift, (forward, sideways), along_base=False)


def _check_shape(meters: Floats, count: int) -> None:
    if meters.ndim == 3 and meters.shape[1:] == (count, 2):
        return
    if meters.ndim not in (1, 2) or meters.shape[-1] != count:
        raise GeometryError(
            f"a displacement at {count} stations must have the shape (V, {count}) or "
            f"(V, {count}, 2), not {meters.shape}"
        )
