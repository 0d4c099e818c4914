"""Curves that are displaced along their normals again and again, computed in one go."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arrays import Booleans, Floats, cached_array, read_only
from ..numbers.differences import differences_on
from . import compiled_rows, row_numbers
from .batch import CurveBatch
from .displaced_curvature import SLOWEST
from .moved_batch import heading_of_rows, moved_along_normal
from .smooth_moves import limits

_AT_ONCE, _AT_ONCE_BY_NUMPY = 48, 20
"""Rows that are moved together: all that is known of them fits into a cache."""
_MANY = 1 << 15
"""Numbers that are displaced from which on numpy is faster with few rows at a time."""


def pushed(base: CurveBatch, displacement: Floats) -> CurveBatch:
    """A batch displaced by (V or 1, S) meters along its left normals. What it is to the last bit
    does not depend on whether it is computed by compiled loops, which is where that pays."""
    if compiled_rows.pays(displacement.size) or displacement.size >= _MANY:
        if isinstance(base, PushedBatch) and base.can_grow:
            return base.grown(displacement)
        if differences_on(base.stations, base.period).stencil is not None:
            return PushedBatch(base, (displacement,))
    return moved_along_normal(base, displacement)


class PushedBatch(CurveBatch):
    """The curves of `root`, displaced by one of `pushes` (V or 1, S) after the other; of these
    the variants `rows`, all where it is None. What is between them is not kept: to put it into
    memory takes more time than to compute it again. As `MovedBatch` to the last bit; stations are
    even."""

    def __init__(
        self, root: CurveBatch, pushes: tuple[Floats, ...], rows: NDArray[Any] | None = None
    ) -> None:
        self.stations, self.closed, self.period = root.stations, root.closed, root.period
        self._root = root
        self._pushes = pushes
        self._is_whole = rows is None
        self._rows = np.arange(max(root.variants, *map(len, pushes))) if rows is None else rows
        self._share()

    @property
    def can_grow(self) -> bool:
        """Whether it is best displaced once more from its root on."""
        return self._is_whole and "_line" not in vars(self)

    def grown(self, displacement: Floats) -> PushedBatch:
        """The same curves, displaced once more."""
        return PushedBatch(self._root, (*self._pushes, displacement))

    @property
    def variants(self) -> int:
        """How many rows."""
        return len(self._rows)

    @property
    def points(self) -> Floats:
        """(V, S, 2) meters."""
        return self._line[0]

    @property
    def curvature(self) -> Floats:
        """(V, S) 1/m, left positive."""
        return self._line[1]

    @property
    def speed(self) -> Floats:
        """(V, S) meters along the curve for a meter along the stations."""
        return self._frame[0]

    @property
    def toward_east(self) -> Floats:
        """(V, S) the part to the east of the unit vectors along the curves."""
        return self._frame[1]

    @property
    def toward_north(self) -> Floats:
        """(V, S) the part to the north of the unit vectors along the curves."""
        return self._frame[2]

    @cached_array
    def heading(self) -> Floats:
        """(V, S) radians, continuous along each curve."""
        found = np.empty((self.variants, len(self.stations)))
        for part, rows in self._parts():
            heading = heading_of_rows(self._root, rows)
            velocity = np.empty((2, len(rows), len(self.stations)))
            for _ in self._states(rows, np.empty(len(rows), bool), velocity):
                heading = heading + np.arctan2(velocity[1], velocity[0])
            found[part] = heading
        return found

    def heading_of(self, rows: NDArray[Any]) -> Floats:
        """(n, S) that of some variants, by index; nothing else of these is computed or copied."""
        if "heading" in vars(self):
            return np.asarray(self.heading[rows])
        return PushedBatch(self._root, self._pushes, self._rows[rows]).heading

    @cached_array
    def folded(self) -> Booleans:
        """(V,) True where a curve, or one that it was made from, is folded."""
        doubtful = np.flatnonzero(~self._line[2])
        rows = self._rows if self._root.variants > 1 else np.zeros_like(self._rows)
        folded = self._root.folded[rows]
        if len(doubtful):
            folded[doubtful] |= self._one_after_the_other(self._rows[doubtful]).folded
        return folded

    def take(self, variants: ArrayLike) -> PushedBatch:
        """The variants chosen by index or by mask."""
        rows = np.arange(self.variants)[np.asarray(variants)]
        batch = PushedBatch(self._root, self._pushes, self._rows[rows])
        for name in vars(self).keys() & {"_line", "_frame"}:
            vars(batch)[name] = tuple(read_only(part[rows]) for part in vars(self)[name])
        return self._computed_for(batch, rows)

    @cached_property
    def _line(self) -> tuple[Floats, Floats, Booleans]:
        """Points, curvature, and (V,) whether it is certain that nothing folds on the way."""
        shape = self.variants, len(self.stations)
        points, curvature, smooth = np.empty((*shape, 2)), np.empty(shape), np.ones(shape[0], bool)
        for part, rows in self._parts():
            state = self._end(rows, smooth[part])
            points[part] = np.moveaxis(state[:, :2], 1, 2)
            curvature[part] = state[:, 3]
        return read_only(points), read_only(curvature), read_only(smooth)

    @cached_property
    def _frame(self) -> tuple[Floats, Floats, Floats]:
        """Speed, and the unit vectors along the curves to the east and to the north."""
        found = np.empty((3, self.variants, len(self.stations)))
        for part, rows in self._parts():
            state = self._end(rows, np.empty(len(rows), bool))
            for number, column in enumerate((2, 4, 5)):
                found[number, part] = state[:, column]
        return read_only(found[0]), read_only(found[1]), read_only(found[2])

    def _parts(self) -> Iterator[tuple[slice, NDArray[Any]]]:
        count = _AT_ONCE if compiled_rows.pays(0) else _AT_ONCE_BY_NUMPY
        for first in range(0, self.variants, count):
            part = slice(first, first + count)
            yield part, self._rows[part]

    def _end(self, rows: NDArray[Any], smooth: Booleans) -> Floats:
        """The state of some variants after all pushes."""
        *_, state = self._states(rows, smooth)
        return state

    def _states(
        self, rows: NDArray[Any], smooth: Booleans, velocity: Floats | None = None
    ) -> Iterator[Floats]:
        """The state of some variants after each push, in the same array; what `smooth` and
        `velocity` hold then see `row_loops.pushed`."""
        root = self._root
        of_root = rows if root.variants > 1 else np.zeros_like(rows)
        arrays = root.speed, root.curvature, root.toward_east, root.toward_north
        state = np.empty((len(rows), 6, len(self.stations)))
        state[:, :2] = np.moveaxis(root.points[of_root], 2, 1)
        for column, array in enumerate(arrays, 2):
            state[:, column] = array[of_root]
        differences = differences_on(self.stations, self.period)
        bounds = (*limits(self.gaps), self.closed)
        if not compiled_rows.pays(0):
            for distance in self._pushes:
                row_numbers.pushed(
                    state, distance, rows, differences, SLOWEST, bounds, smooth, velocity
                )
                yield state
            return
        stencil = differences.stencil
        assert stencil is not None
        numbers = stencil[0], SLOWEST, stencil[1]
        for distance in self._pushes:
            compiled_rows.pushed(state, distance, rows, numbers, bounds, smooth, velocity)
            yield state

    def _one_after_the_other(self, rows: NDArray[Any]) -> CurveBatch:
        """Some variants, with all that is between."""
        root = self._root
        found = root.take(rows) if root.variants > 1 else root
        for push in self._pushes:
            found = moved_along_normal(found, push[rows] if len(push) > 1 else push)
        return found
