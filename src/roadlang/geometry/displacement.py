"""Curves displaced in many ways at once.

A curve `r(s)` with unit tangent `t`, left normal `n`, speed `v = |r'|` and curvature `k` that is
displaced by `d(s)` has the velocity `f t + g n` with `f = v + d' t` and `g = d' n`. Hence its speed
is `w = hypot(f, g)`, its heading turns by `atan2(g, f)` and its curvature is
`(v k + (f g' - g f') / w^2) / w`. Of a displacement `d = e n` along the normal, `f = v (1 - k e)`
and `g = e'`. Derivatives of displacements are second-order differences, so that what is computed
here is accurate to second order in the gap of the stations.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .arrays import Booleans, Floats, cached_array, finite
from .batch import CurveBatch
from .curve import Curve
from .differences import derivative
from .displaced_curvature import SLOWEST, displaced_curvature
from .errors import GeometryError
from .folding import fold_of_points, turns_too_much
from .frame import CurveFrame
from .smooth_moves import surely_smooth


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
        return _turned((straight, left), (progress, self.slope), self.speed)

    @cached_array
    def speed(self) -> Floats:
        """(V, S) meters along the curve for a meter along the stations."""
        return _size(1.0 - self.frame.curvature * self.displacement, self.slope)

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
        next; see `roadlang.geometry.folding`."""
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


class MovedBatch(CurveBatch):
    """Another batch, moved: its points and velocities, `forward` and to the left of the base's.

    `along_base`: whether it follows the base, displaced along its normal, so that it must go
    forward where the base does.
    """

    def __init__(
        self, base: CurveBatch, points: Floats, velocity: tuple[Floats, Floats], along_base: bool
    ) -> None:
        super().__init__(base.stations, points, base.closed, base.period)
        self._base = base
        self._rows: NDArray[Any] | None = None
        self.forward, self.sideways = (np.broadcast_to(part, points.shape[:2]) for part in velocity)
        self.along_base = along_base

    @cached_property
    def base(self) -> CurveBatch:
        """What was moved; its rows are chosen when they are first needed."""
        if self._rows is None or self._base.variants == 1:
            return self._base
        return self._base.take(self._rows)

    @cached_array
    def heading(self) -> Floats:
        """(V, S) radians, continuous along each curve."""
        if self._rows is None or "base" in vars(self):
            before = self.base.heading
        else:  # of all that the base has, its heading alone
            before = _heading_of(self._base, self._rows)
        return np.asarray(before + np.arctan2(self.sideways, self.forward))

    def heading_of(self, rows: NDArray[Any]) -> Floats:
        """(n, S) that of some variants, by index; nothing else of these is computed or copied."""
        if "heading" in vars(self):
            return np.asarray(self.heading[rows])
        before = _heading_of(self._base, rows if self._rows is None else self._rows[rows])
        return np.asarray(before + np.arctan2(self.sideways[rows], self.forward[rows]))

    @cached_array
    def toward_east(self) -> Floats:
        """(V, S) the part to the east of the unit vectors along the curves."""
        base = self.base
        return _turned(
            (base.toward_east, -base.toward_north), (self.forward, self.sideways), self.speed
        )

    @cached_array
    def toward_north(self) -> Floats:
        """(V, S) the part to the north of the unit vectors along the curves."""
        base = self.base
        return _turned(
            (base.toward_north, base.toward_east), (self.forward, self.sideways), self.speed
        )

    @cached_array
    def speed(self) -> Floats:
        """(V, S) meters along the curve for a meter along the stations."""
        return _size(self.forward, self.sideways)

    @cached_array
    def curvature(self) -> Floats:
        """(V, S) 1/m, left positive."""
        faster = derivative(self.forward, self.stations, self.period)
        faster *= self.sideways
        found = derivative(self.sideways, self.stations, self.period)
        found *= self.forward
        found -= faster
        speed = np.maximum(self.speed, SLOWEST)
        found /= np.multiply(speed, speed, out=faster)
        found += self.base.speed * self.base.curvature
        found /= speed
        return found

    @cached_array
    def folded(self) -> Booleans:
        """(V,) True where a curve, or one that it was made from, is folded."""
        doubtful = np.ones(self.variants, dtype=bool)
        if self.along_base:
            steps = self.step_bounds, self.base.step_bounds
            doubtful = ~surely_smooth(*steps, self.curvature, self.gaps, self.closed)
        if doubtful.any():
            doubtful[doubtful] = (self if doubtful.all() else self.take(doubtful))._is_folded()
        return np.asarray(doubtful | self.base.folded)

    def _is_folded(self) -> Booleans:
        """(V,) the same, without what it was made from."""
        follows = (self.base.points, self.base.steps) if self.along_base else None
        folded = fold_of_points(self.points, self.gaps, self.closed, follows)
        return folded | turns_too_much(self.curvature, self.steps, self.closed)

    def take(self, variants: ArrayLike) -> MovedBatch:
        """The variants chosen by index or by mask."""
        rows = np.arange(self.variants)[np.asarray(variants)]
        velocity = self.forward[rows], self.sideways[rows]
        batch = MovedBatch(self._base, self.points[rows], velocity, self.along_base)
        batch._rows = rows if self._rows is None else self._rows[rows]
        return self._computed_for(batch, rows)


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
    return DisplacedBatch(base, meters) if isinstance(base, CurveFrame) else _pushed(base, meters)


def sample(curve: Curve, stations: ArrayLike) -> DisplacedBatch:
    """The curve itself as a batch of one."""
    return undisplaced(CurveFrame.of(curve, stations))


def undisplaced(frame: CurveFrame) -> DisplacedBatch:
    """The curve of a frame itself as a batch of one."""
    return DisplacedBatch(frame, np.zeros((1, len(frame.stations))))


def _pushed(base: CurveBatch, displacement: Floats) -> MovedBatch:
    """Along the normal of a batch."""
    points = np.empty((max(len(displacement), base.variants), *base.points.shape[1:]))
    np.subtract(base.points[..., 0], displacement * base.toward_north, out=points[..., 0])
    np.add(base.points[..., 1], displacement * base.toward_east, out=points[..., 1])
    forward = base.curvature * displacement
    np.subtract(1.0, forward, out=forward)
    forward *= base.speed
    sideways = derivative(displacement, base.stations, base.period)
    return MovedBatch(base, points, (forward, sideways), along_base=True)


def _heading_of(base: CurveBatch, rows: NDArray[Any]) -> Floats:
    """(n, S) of some variants of what may be the same for all."""
    return base.heading if base.variants == 1 else base.heading_of(rows)


def _size(forward: Floats, sideways: Floats) -> Floats:
    """Of velocities, which are neither huge nor tiny: `hypot` takes ten times as long."""
    found = forward * forward
    found += sideways * sideways
    return np.asarray(np.sqrt(found, out=found))


def _turned(axis: tuple[Floats, Floats], velocity: tuple[Floats, Floats], speed: Floats) -> Floats:
    """One coordinate of the direction of velocities (forward, to the left), of which `speed` is
    the size; `axis`: the same coordinate of the unit vectors forward and to the left. Angles would
    have to be found and resolved again."""
    found = axis[0] * velocity[0]
    found += axis[1] * velocity[1]
    found /= np.maximum(speed, SLOWEST)
    return found


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
