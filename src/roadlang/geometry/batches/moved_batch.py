"""A batch of curves that was moved: everything of it is computed from how the points moved."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arrays import Booleans, Floats, cached_array
from ..numbers.differences import derivative
from .batch import CurveBatch
from .displaced_curvature import SLOWEST
from .folding import fold_of_points, turns_too_much
from .smooth_moves import surely_smooth


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
            before = heading_of_rows(self._base, self._rows)
        return np.asarray(before + np.arctan2(self.sideways, self.forward))

    def heading_of(self, rows: NDArray[Any]) -> Floats:
        """(n, S) that of some variants, by index; nothing else of these is computed or copied."""
        if "heading" in vars(self):
            return np.asarray(self.heading[rows])
        before = heading_of_rows(self._base, rows if self._rows is None else self._rows[rows])
        return np.asarray(before + np.arctan2(self.sideways[rows], self.forward[rows]))

    @cached_array
    def toward_east(self) -> Floats:
        """(V, S) the part to the east of the unit vectors along the curves."""
        base = self.base
        return turned(
            (base.toward_east, -base.toward_north), (self.forward, self.sideways), self.speed
        )

    @cached_array
    def toward_north(self) -> Floats:
        """(V, S) the part to the north of the unit vectors along the curves."""
        base = self.base
        return turned(
            (base.toward_north, base.toward_east), (self.forward, self.sideways), self.speed
        )

    @cached_array
    def speed(self) -> Floats:
        """(V, S) meters along the curve for a meter along the stations."""
        return size_of(self.forward, self.sideways)

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


def moved_along_normal(base: CurveBatch, displacement: Floats) -> MovedBatch:
    """A batch displaced by (V or 1, S) meters along its left normals."""
    points = np.empty((max(len(displacement), base.variants), *base.points.shape[1:]))
    np.subtract(base.points[..., 0], displacement * base.toward_north, out=points[..., 0])
    np.add(base.points[..., 1], displacement * base.toward_east, out=points[..., 1])
    forward = base.curvature * displacement
    np.subtract(1.0, forward, out=forward)
    forward *= base.speed
    sideways = derivative(displacement, base.stations, base.period)
    return MovedBatch(base, points, (forward, sideways), along_base=True)


def heading_of_rows(base: CurveBatch, rows: NDArray[Any]) -> Floats:
    """(n, S) of some variants of what may be the same for all."""
    return base.heading if base.variants == 1 else base.heading_of(rows)


def size_of(forward: Floats, sideways: Floats) -> Floats:
    """Of velocities, which are neither huge nor tiny: `hypot` takes ten times as long."""
    found = forward * forward
    found += sideways * sideways
    return np.asarray(np.sqrt(found, out=found))


def turned(axis: tuple[Floats, Floats], velocity: tuple[Floats, Floats], speed: Floats) -> Floats:
    """One coordinate of the direction of velocities (forward, to the left), of which `speed` is
    the size; `axis`: the same coordinate of the unit vectors forward and to the left. Angles would
    have to be found and resolved again."""
    found = axis[0] * velocity[0]
    found += axis[1] * velocity[1]
    found /= np.maximum(speed, SLOWEST)
    return found
