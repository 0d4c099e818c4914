"""Where sampled curves cross themselves or each other, for many variants at once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Booleans, Floats, Integers, cross
from .batch import CurveBatch

_BLOCK = 16
_PAIRS_AT_ONCE = 2048
_BOXES_AT_ONCE = 4_000_000


def self_crossings(batch: CurveBatch) -> tuple[Integers, Integers, Integers]:
    """Variant, step and later step of every crossing of a curve with itself."""
    steps = _Steps.of(batch)
    first, second = np.triu_indices(steps.blocks)
    rows = max(1, _BOXES_AT_ONCE // len(first))
    parts = [
        _self_crossings(steps.take(slice(row, row + rows)), first, second, row)
        for row in range(0, batch.variants, rows)
    ]
    variant, step, later = (np.concatenate(column) for column in zip(*parts, strict=True))
    return _unneighbored(variant, step, later, count=steps.count, closed=batch.closed)


def crossings(a: CurveBatch, b: CurveBatch) -> tuple[Integers, Integers, Integers]:
    """Variant, step of `a` and step of `b` of every crossing; V may be 1 in one of them."""
    left, right = _Steps.of(a), _Steps.of(b)
    first, second = (grid.ravel() for grid in np.indices((left.blocks, right.blocks)))
    variant, pair = np.nonzero(left.overlap(right, first, second))
    return _crossings(left, right, variant, first[pair], second[pair])


def _self_crossings(
    steps: _Steps, first: Integers, second: Integers, offset: int
) -> tuple[Integers, Integers, Integers]:
    """Of some variants, the first of which has the number `offset`; neighbors included."""
    near = steps.overlap(steps, first, second)
    neighbors = np.flatnonzero(second - first <= 1)
    near[:, neighbors] &= ~steps.onward(first[neighbors], second[neighbors])
    variant, pair = np.nonzero(near)
    variant, step, later = _crossings(steps, steps, variant, first[pair], second[pair])
    return variant + offset, step, later


@dataclass(frozen=True, eq=False)
class _Steps:
    """The steps of curves in blocks: `start`, `stop` are (V, blocks, block, 2)."""

    start: Floats
    stop: Floats
    low: Floats
    high: Floats
    count: int

    @classmethod
    def of(cls, batch: CurveBatch) -> _Steps:
        points = batch.points
        if batch.closed:
            points = np.concatenate([points, points[:, :1]], axis=1)
        count = points.shape[1] - 1
        # The last block is filled with the last point, a step of no length; it is cut off later.
        padding = np.repeat(points[:, -1:], -count % _BLOCK, axis=1)
        points = np.concatenate([points, padding], axis=1)
        shape = (len(points), -1, _BLOCK, 2)
        start, stop = points[:, :-1].reshape(shape), points[:, 1:].reshape(shape)
        low = np.minimum(start.min(axis=2), stop.min(axis=2))
        high = np.maximum(start.max(axis=2), stop.max(axis=2))
        return cls(start, stop, low, high, count)

    def take(self, rows: slice) -> _Steps:
        """Some of the variants."""
        return _Steps(
            self.start[rows], self.stop[rows], self.low[rows], self.high[rows], self.count
        )

    @property
    def blocks(self) -> int:
        return int(self.start.shape[1])

    def overlap(self, other: _Steps, first: Integers, second: Integers) -> Booleans:
        """(V, pairs) whether the boxes of two blocks touch."""
        apart = (self.low[:, first] > other.high[:, second]) | (
            other.low[:, second] > self.high[:, first]
        )
        return np.asarray(~apart.any(axis=-1))

    def onward(self, first: Integers, second: Integers) -> Booleans:
        """(V, pairs) whether all steps of two blocks go one way: then they cannot cross."""
        direction = self.stop[:, second, -1] - self.start[:, first, 0]
        ahead = np.ones((len(self.start), len(first)), dtype=bool)
        for block in (first, second):
            chord = self.stop[:, block] - self.start[:, block]
            along = (chord * direction[:, :, None]).sum(axis=-1)
            ahead &= ((along > 0.0) | ((chord == 0.0).all(axis=-1))).all(axis=-1)
        return ahead


def _crossings(
    left: _Steps, right: _Steps, variant: Integers, first: Integers, second: Integers
) -> tuple[Integers, Integers, Integers]:
    """Crossings within the given pairs of blocks."""
    found = []
    for begin in range(0, len(variant), _PAIRS_AT_ONCE):
        rows = slice(begin, begin + _PAIRS_AT_ONCE)
        v, i, j = variant[rows], first[rows], second[rows]
        p, q = (ends[v % len(ends), i][:, :, None] for ends in (left.start, left.stop))
        r, t = (ends[v % len(ends), j][:, None, :] for ends in (right.start, right.stop))
        pair, a, b = np.nonzero(_segments_meet(p, q, r, t))
        found.append((v[pair], i[pair] * _BLOCK + a, j[pair] * _BLOCK + b))
    if not found:
        empty = np.zeros(0, dtype=np.int64)
        return empty, empty, empty
    v, i, j = (np.concatenate(column) for column in zip(*found, strict=True))
    real = (i < left.count) & (j < right.count)
    return v[real], i[real], j[real]


def _segments_meet(p: Floats, q: Floats, r: Floats, t: Floats) -> Booleans:
    """Whether segments p-q and r-t share a point (Cormen et al., ch. 33)."""
    boxes = (np.minimum(p, q) <= np.maximum(r, t)) & (np.minimum(r, t) <= np.maximum(p, q))
    d, e = q - p, t - r
    astride = (cross(d, r - p) * cross(d, t - p) <= 0.0) & (
        cross(e, p - r) * cross(e, q - r) <= 0.0
    )
    return np.asarray(astride & boxes.all(axis=-1))


def _unneighbored(
    variant: Integers, first: Integers, second: Integers, count: int, closed: bool
) -> tuple[Integers, Integers, Integers]:
    """Without the pairs that share an end, and each pair once."""
    keep = second - first > 1
    if closed:
        keep &= second - first < count - 1
    return variant[keep], first[keep], second[keep]
