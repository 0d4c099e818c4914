"""The nearest point of a line that counts as another part of it, found block by block.

Two points count where the way between them along the line is more than `ratio` times the straight
way. Bounds on both ways, of blocks of points at once, leave few pairs to look at: hardly any of a
road that goes on, those at nearly the least distance of one that winds.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from ..arrays import Booleans, Floats, Integers

_BLOCK = 64
_PAIRS_AT_ONCE = 1_000_000
_ROUNDING = 1e-9


@dataclass(frozen=True)
class BlockRange:
    """The points `first` to `last` (B,) of B blocks, `last` included."""

    first: Integers
    last: Integers


class WayAlong(Protocol):
    """Meters from points of one line, along it and perhaps on along another, to points there."""

    def between(self, rows: Integers, columns: Integers) -> Floats:
        """(rows, columns) meters."""
        ...

    def bounds(self, rows: BlockRange, columns: BlockRange) -> tuple[Floats, Floats]:
        """(B,) each: no more, and no less, than the ways between the points of a block and those of
        B others."""
        ...


@dataclass(frozen=True)
class AlongOneLine:
    """`places` (S,) of its points, meters; `around`: the length of a closed line."""

    places: Floats
    around: float | None

    def between(self, rows: Integers, columns: Integers) -> Floats:
        """(rows, columns) meters, the shorter way round a closed line."""
        along = np.abs(self.places[rows, None] - self.places[columns])
        return along if self.around is None else np.minimum(along, self.around - along, out=along)

    def bounds(self, rows: BlockRange, columns: BlockRange) -> tuple[Floats, Floats]:
        """(B,) each, see `WayAlong`."""
        begin, end = self.places[rows.first], self.places[rows.last]
        first, last = self.places[columns.first], self.places[columns.last]
        low = np.maximum(np.maximum(first - end, begin - last), 0.0)
        high = np.maximum(last - begin, end - first)
        if self.around is None:
            return low, high
        return np.minimum(low, self.around - high), np.minimum(high, self.around - low)


@dataclass(frozen=True)
class AlongTwoLines:
    """From one line on to another through `ends` that they share: meters from all points of the
    first, and of the second, to each of these. Without one there is no way."""

    ends: list[tuple[Floats, Floats]]

    def between(self, rows: Integers, columns: Integers) -> Floats:
        """(rows, columns) meters, infinite where there is no way."""
        shortest = np.full((len(rows), len(columns)), np.inf)
        for travel, beyond in self.ends:
            np.minimum(shortest, travel[rows, None] + beyond[columns], out=shortest)
        return shortest

    def bounds(self, rows: BlockRange, columns: BlockRange) -> tuple[Floats, Floats]:
        """(B,) each, see `WayAlong`. Meters to an end grow or shrink all along a line."""
        low = np.full(len(columns.first), np.inf)
        high = low.copy()
        for travel, beyond in self.ends:
            ours = np.stack([travel[rows.first], travel[rows.last]])
            theirs = np.stack([beyond[columns.first], beyond[columns.last]])
            np.minimum(low, ours.min(axis=0) + theirs.min(axis=0), out=low)
            np.minimum(high, ours.max(axis=0) + theirs.max(axis=0), out=high)
        return low, high


def nearest_points(
    points: Floats, line: Floats, along: WayAlong, ratio: float
) -> tuple[Integers, Booleans]:
    """(S,) each: the index of the point of `line` (T, 2) nearest to each of `points` (S, 2) of
    those that count, the first of several, and whether any does."""
    index = np.zeros(len(points), dtype=np.int64)
    counted = np.zeros(len(points), dtype=bool)
    ours, theirs = _Boxes.of(points), _Boxes.of(line)
    for block in range(len(ours.span.first)):
        chosen = _chosen(ours.at(block), theirs, along, ratio)
        if not len(chosen):
            continue
        spans = zip(theirs.span.first[chosen], theirs.span.last[chosen], strict=True)
        columns = np.concatenate([np.arange(first, last + 1) for first, last in spans])
        step = max(1, _PAIRS_AT_ONCE // len(columns))
        for start in range(ours.span.first[block], ours.span.last[block] + 1, step):
            rows = np.arange(start, min(start + step, int(ours.span.last[block]) + 1))
            near = _distances(points[rows], line[columns])
            near[along.between(rows, columns) <= ratio * near] = np.inf
            place = near.argmin(axis=1)
            index[rows] = columns[place]
            counted[rows] = np.isfinite(near[np.arange(len(rows)), place])
    return index, counted


@dataclass(frozen=True)
class _Boxes:
    """Blocks of consecutive points, and the corners (B, 2) of the boxes around them."""

    span: BlockRange
    low: Floats
    high: Floats

    @classmethod
    def of(cls, points: Floats) -> _Boxes:
        first = np.arange(0, len(points), _BLOCK)
        last = np.minimum(first + _BLOCK, len(points)) - 1
        low = np.minimum.reduceat(points, first, axis=0)
        return cls(BlockRange(first, last), low, np.maximum.reduceat(points, first, axis=0))

    def at(self, block: int) -> _Boxes:
        """One of the blocks."""
        part = slice(block, block + 1)
        span = BlockRange(self.span.first[part], self.span.last[part])
        return _Boxes(span, self.low[part], self.high[part])


def _chosen(ours: _Boxes, theirs: _Boxes, along: WayAlong, ratio: float) -> Integers:
    """The blocks that may hold the nearest point, of those that count, to a point of one block."""
    apart = np.maximum(theirs.low - ours.high, ours.low - theirs.high)
    least = np.hypot(*np.maximum(apart, 0.0).T)
    greatest = np.hypot(*np.maximum(theirs.high - ours.low, ours.high - theirs.low).T)
    shortest, longest = along.bounds(ours.span, theirs.span)
    may_count = longest > ratio * least * (1.0 - _ROUNDING) - _ROUNDING
    surely_counts = shortest > ratio * greatest * (1.0 + _ROUNDING) + _ROUNDING
    within = greatest[surely_counts].min(initial=np.inf) * (1.0 + _ROUNDING) + _ROUNDING
    return np.flatnonzero(may_count & (least <= within))


def _distances(points: Floats, others: Floats) -> Floats:
    """(rows, columns) meters."""
    square = points[:, 0, None] - others[:, 0]
    square *= square
    across = points[:, 1, None] - others[:, 1]
    across *= across
    square += across
    return np.sqrt(square, out=square)
