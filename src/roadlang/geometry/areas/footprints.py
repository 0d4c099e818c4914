"""Oriented rectangles on the ground: whether they overlap, how far apart they are.

Only + - * / sqrt, abs, min and max of elements besides one sine and cosine of each heading, so that
one pair gives the same bytes as the same pair among a million.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Floats, Integers

_MOST_CELLS = 100_000
"""Along a side of the plane"""
_AT_ONCE = 2_000_000
"""Pairs that are looked at together: their arrays stay below some 100 MB."""


@dataclass(frozen=True, eq=False)
class Footprints:
    """Rectangles: centers in meters, heading in radians, length along the heading, width across.

    The arrays have one shape, or shapes that broadcast to one.
    """

    x: Floats
    y: Floats
    heading: Floats
    length: Floats
    width: Floats

    @cached_property
    def cosine(self) -> Floats:
        """Of the heading."""
        return np.cos(self.heading)

    @cached_property
    def sine(self) -> Floats:
        """Of the heading."""
        return np.sin(self.heading)

    @cached_property
    def radius(self) -> Floats:
        """Meters from the center to a corner."""
        return np.asarray(0.5 * np.sqrt(self.length * self.length + self.width * self.width))

    @cached_property
    def corners(self) -> Floats:
        """(..., 4, 2) meters, counter-clockwise from the front left."""
        along = 0.5 * np.stack([self.length, -self.length, -self.length, self.length], axis=-1)
        across = 0.5 * np.stack([self.width, self.width, -self.width, -self.width], axis=-1)
        cosine, sine = self.cosine[..., None], self.sine[..., None]
        x = self.x[..., None] + along * cosine - across * sine
        y = self.y[..., None] + along * sine + across * cosine
        return np.stack([x, y], axis=-1)

    def take(self, chosen: ArrayLike) -> Footprints:
        """The rectangles at these indices, of arrays of one dimension."""
        index = np.asarray(chosen)
        parts = (self.x, self.y, self.heading, self.length, self.width)
        return Footprints(*(part[index] for part in parts))


def separation(a: Footprints, b: Footprints) -> Floats:
    """Meters of the widest gap between two rectangles along one of their four sides; below zero,
    how deep they overlap.

    Two convex shapes are apart when some line separates them, and of rectangles one that is
    parallel to a side (Gottschalk, Lin, Manocha 1996). It is at most the distance: of rectangles
    that face each other with their corners it is less.
    """
    dx, dy = b.x - a.x, b.y - a.y
    cosine = np.abs(a.cosine * b.cosine + a.sine * b.sine)
    sine = np.abs(a.sine * b.cosine - a.cosine * b.sine)
    along_a = np.abs(dx * a.cosine + dy * a.sine)
    across_a = np.abs(dy * a.cosine - dx * a.sine)
    along_b = np.abs(dx * b.cosine + dy * b.sine)
    across_b = np.abs(dy * b.cosine - dx * b.sine)
    gaps = (
        along_a - 0.5 * (a.length + b.length * cosine + b.width * sine),
        across_a - 0.5 * (a.width + b.length * sine + b.width * cosine),
        along_b - 0.5 * (b.length + a.length * cosine + a.width * sine),
        across_b - 0.5 * (b.width + a.length * sine + a.width * cosine),
    )
    return np.maximum(np.maximum(gaps[0], gaps[1]), np.maximum(gaps[2], gaps[3]))


def distance_between(a: Footprints, b: Footprints) -> Floats:
    """Meters between two rectangles; 0 or below, the separation, where they overlap.

    Disjoint rectangles are nearest at a corner of one of them.
    """
    nearest = np.minimum(_from_corners(a, b), _from_corners(b, a))
    gap = separation(a, b)
    return np.where(gap <= 0.0, gap, nearest)


def _from_corners(a: Footprints, b: Footprints) -> Floats:
    """Meters from the nearest corner of `a` to the rectangle `b`."""
    dx = a.corners[..., 0] - b.x[..., None]
    dy = a.corners[..., 1] - b.y[..., None]
    cosine, sine = b.cosine[..., None], b.sine[..., None]
    along = np.maximum(np.abs(dx * cosine + dy * sine) - 0.5 * b.length[..., None], 0.0)
    across = np.maximum(np.abs(dy * cosine - dx * sine) - 0.5 * b.width[..., None], 0.0)
    return np.asarray(np.sqrt(along * along + across * across).min(axis=-1))


def close_pairs(
    a: Footprints,
    b: Footprints,
    margin: float = 0.0,
    group_a: Integers | None = None,
    group_b: Integers | None = None,
) -> tuple[Integers, Integers]:
    """Indices (i, j) of the pairs of (n,) and (m,) rectangles whose circles are `margin` or less
    apart, by i, then j; with groups, of the same group only.

    What lies in cells that do not touch is never compared.
    """
    found = list(_swept(a, b, margin, group_a, group_b)) if len(a.x) and len(b.x) else []
    if not found:
        return np.zeros(0, np.int64), np.zeros(0, np.int64)
    i, j = (np.concatenate(part) for part in zip(*found, strict=True))
    order = np.lexsort((j, i))
    return i[order], j[order]


def _swept(
    a: Footprints,
    b: Footprints,
    margin: float,
    group_a: Integers | None,
    group_b: Integers | None,
) -> Iterator[tuple[Integers, Integers]]:
    first, count, order = _candidates(a, b, margin, group_a, group_b)
    index = np.tile(np.arange(len(a.x)), 3)
    ends = np.cumsum(count)
    start = 0
    while start < len(count):
        base = int(ends[start - 1]) if start else 0
        stop = max(start + 1, int(np.searchsorted(ends, base + _AT_ONCE, side="right")))
        part = count[start:stop]
        i = np.repeat(index[start:stop], part)
        within = np.arange(len(i)) - np.repeat(np.cumsum(part) - part, part)
        j = order[np.repeat(first[start:stop], part) + within]
        dx, dy = b.x[j] - a.x[i], b.y[j] - a.y[i]
        limit = a.radius[i] + b.radius[j] + margin
        near = dx * dx + dy * dy <= limit * limit
        yield i[near], j[near]
        start = stop


def _candidates(
    a: Footprints,
    b: Footprints,
    margin: float,
    group_a: Integers | None,
    group_b: Integers | None,
) -> tuple[Integers, Integers, Integers]:
    """For each `a`, in three rows of cells, the first of `b` there and how many, in an `order`.

    The cells are as wide as two rectangles may be apart, so that what is near lies in the same one
    or in one of its neighbors.
    """
    x, y = min(a.x.min(), b.x.min()), min(a.y.min(), b.y.min())
    wide, high = max(a.x.max(), b.x.max()) - x, max(a.y.max(), b.y.max()) - y
    distance = float(a.radius.max() + b.radius.max()) + margin
    cell = max(distance * (1.0 + 1e-9), float(max(wide, high)) / _MOST_CELLS)
    columns, rows = int(wide / cell) + 3, int(high / cell) + 3

    def key(boxes: Footprints, group: Integers | None) -> Integers:
        across = ((boxes.x - x) / cell).astype(np.int64) + 1
        up = ((boxes.y - y) / cell).astype(np.int64) + 1
        return np.asarray(((0 if group is None else group) * rows + up) * columns + across)

    key_b = key(b, group_b)
    order = np.argsort(key_b, kind="stable")
    ordered = key_b[order]
    middle = key(a, group_a)
    keys = np.concatenate([middle - columns, middle, middle + columns])
    first = np.searchsorted(ordered, keys - 1)
    return first, np.searchsorted(ordered, keys + 1, side="right") - first, order
