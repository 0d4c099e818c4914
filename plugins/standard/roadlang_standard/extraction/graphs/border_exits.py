"""Where roads leave the picture: in the middle of their cut, however obliquely it cuts them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans, Floats

from ..curves.smoothing import stations
from .chains import direction
from .graph import Graph, Line
from .graph_cleanup import at_border

_LONGEST = 4.0
"""Maximum length of a cut, in widths of the road; a longer cut belongs to a road along the
border."""
_WHOLE = 1.4
"""Least distance from the border to the center of the largest disc inside the surface, in radii of
the disc. On the bisector of border and edge, which a skeleton follows there, it is 1."""
_CORNER, _BENDS, _INSIDE = 2.0, 3.0, 0.9
"""Within `_CORNER` widths of a corner of the picture, a road leaves through the corner. Its bend is
taken from the last `_BENDS` widths, and `_INSIDE` of its way out must lie on the surface."""
_BEND = 0.5
"""Maximum apparent turn of a road on its way out, in radians."""


def lead_out(graph: Graph, mask: Booleans, inner: NDArray[np.float32], width: float) -> set[int]:
    """Lead dead ends whose surface is cut by one side of the picture to the middle of the cut, and
    those at a corner on as they bend, in place; the nodes there.

    `mask` (h, w) is the surface, `inner` how far its pixels are from its edge, `width` the usual
    width of roads. Near the border a skeleton turns toward a corner of the surface: where the disc
    inside it would be cut, its points are dropped.
    """
    degree = graph.degree()
    done = set()
    for line in graph.lines:
        for side, node in ((0, line.start), (1, line.end)):
            if line.closed or degree[node] != 1:
                continue
            if at_border(graph.nodes[node], mask.shape, 0.7 * width + 2):
                points = line.points if side == 0 else line.points[::-1]
                found = _led_out(points, mask, inner, width)
                if found is not None:
                    line.points = found if side == 0 else found[::-1]
                    graph.nodes[node] = found[0]
                    done.add(node)
    return done


def _led_out(
    points: Floats, mask: Booleans, inner: NDArray[np.float32], width: float
) -> Floats | None:
    """A line from the border; None where it is cut by no single side and not at a corner."""
    kept = _whole(points, inner, width)
    if len(kept) <= 2:
        return None
    if _is_at_corner(points[0], mask, width):
        return _carried_on(kept, mask, width)
    goal = _middle_of_cut(points[0], mask, _LONGEST * width)
    if goal is None:
        return None
    ahead = -direction(Line(0, 1, kept), 0, 2 * width + 4)
    way = goal - kept[0]
    away = float(np.hypot(*way))
    if away < 1.0 or float(ahead @ way) < np.cos(_BEND) * away:
        return None
    return np.vstack([goal, kept])


def _whole(points: Floats, inner: NDArray[np.float32], width: float) -> Floats:
    """The line from where the disc inside the surface is no longer cut by the border."""
    height, wide = inner.shape
    columns, rows = np.clip(np.round(points).astype(int), 0, (wide - 1, height - 1)).T
    x, y = points.T
    room = np.minimum.reduce([x + 0.5, y + 0.5, wide - 0.5 - x, height - 0.5 - y])
    cut = (room < _WHOLE * inner[rows, columns] + 1.0) & (
        np.hypot(*(points - points[0]).T) < _LONGEST * width
    )
    return points[int(np.flatnonzero(cut).max(initial=-1)) + 1 :]


def _is_at_corner(end: Floats, mask: Booleans, width: float) -> bool:
    """Whether the surface at an end of the skeleton holds a corner of the picture."""
    last = np.array(mask.shape[::-1]) - 1
    x, y = corner = np.where(end < last / 2, 0, last)
    return bool(mask[y, x] and np.hypot(*(end - corner)) < _CORNER * width)


def _carried_on(kept: Floats, mask: Booleans, width: float) -> Floats | None:
    """The line carried on to the border as it bends; None if that leaves the surface."""
    look = int(np.argmax(np.append(stations(kept), np.inf) > _BENDS * width + 4))
    seen = kept[: max(look, 5)]
    along = stations(seen)
    ahead = np.arange(1.0, _LONGEST * width + 2)
    bend = np.polynomial.polynomial.polyfit(along, seen - seen[0], 2)
    there = seen[0] + np.polynomial.polynomial.polyval(-ahead, bend, tensor=True).T
    last = np.array(mask.shape[::-1]) - 1
    out = np.flatnonzero(((there < 0) | (there > last)).any(axis=1))
    if not len(out):
        return None
    there = np.clip(there[: out[0] + 1], -0.5, last + 0.5)
    columns, rows = np.clip(np.round(there).astype(int), 0, last).T
    if mask[rows, columns].mean() < _INSIDE:
        return None
    return np.vstack([there[::-1], kept])


def _middle_of_cut(end: Floats, mask: Booleans, longest: float) -> Floats | None:
    """The middle of the run of surface at the border next to an end of the skeleton; None if it
    reaches a corner of the picture, or is longer than `longest`."""
    height, wide = mask.shape
    x, y = end
    gaps = (x, wide - 1 - x, y, height - 1 - y)
    side = int(np.argmin(gaps))
    cut = (mask[:, 0], mask[:, -1], mask[0], mask[-1])[side]
    at = int(np.clip(round(float(y if side < 2 else x)), 0, len(cut) - 1))
    if not cut[at]:
        return None
    empty = np.flatnonzero(~cut)
    after = int(np.searchsorted(empty, at))
    if after in (0, len(empty)) or empty[after] - empty[after - 1] - 1 > longest:
        return None
    middle = (empty[after] + empty[after - 1]) / 2
    fixed = (-0.5, wide - 0.5, -0.5, height - 0.5)[side]
    return np.array([fixed, middle] if side < 2 else [middle, fixed])
