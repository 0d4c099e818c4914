"""Painted shapes as polygons."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from ..geometry.arrays import Floats
from .junction_curbs import beside_curb
from .junction_paint import PaintedShape


def paint_rings(shapes: Iterable[PaintedShape]) -> Iterator[Floats]:
    """Convex rings (n, 2), counter-clockwise: lines are made of rectangles, solid ones that bend
    of quadrilaterals that meet at the bends."""
    for shape in shapes:
        if not shape.width:
            yield shape.points if _area(shape.points) > 0.0 else shape.points[::-1]
            continue
        if shape.dashes is None and len(shape.points) > 2:
            yield from _ribbon(shape.points, shape.width)
            continue
        for start, stop in zip(shape.points[:-1], shape.points[1:], strict=True):
            yield from _strokes(start, stop, shape.width, shape.dashes)


def _ribbon(points: Floats, width: float) -> Iterator[Floats]:
    half = np.full(len(points), 0.5 * width)
    left, right = beside_curb(points, half), beside_curb(points, -half)
    for i in range(len(points) - 1):
        yield np.array([right[i], right[i + 1], left[i + 1], left[i]])


def _strokes(
    start: Floats, stop: Floats, width: float, dashes: tuple[float, float] | None
) -> Iterator[Floats]:
    """Rectangles along a line."""
    along = stop - start
    length = float(np.hypot(*along))
    if length < 1e-6:
        return
    along = along / length
    beside = 0.5 * width * np.array([-along[1], along[0]])
    on, off = dashes or (length, 0.0)
    s = 0.0
    while s < length - 1e-6:
        first, last = start + s * along, start + min(s + on, length) * along
        yield np.array([first - beside, last - beside, last + beside, first + beside])
        s += on + off


def _area(ring: Floats) -> float:
    x, y = ring.T
    return float(0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1)))
