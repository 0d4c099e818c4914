"""Roads drawn with a gap on both sides of another one: they pass over it or under it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from roadlang.geometry import Floats

from .dead_ends import dead_ends
from .graph import Graph, Line
from .graph_cleanup import join

_SPAN = 6.0
"""Maximum distance between the two ends, in widths: both roads, and the gaps."""
_HOOK, _SEEN = 1.0, 2.5
"""The last `_HOOK` widths of an end may turn aside; its direction is measured over the `_SEEN`
widths before them."""
_STRAIGHT = 0.96
"""Least cosine between either end's direction and the way to the other one."""
_MIDDLE, _ACROSS = (0.25, 0.75), 0.5
"""The other road crosses the way between these shares of its length, at an angle with at least this
sine."""


@dataclass(frozen=True)
class _End:
    """Where a line is seen to end, less what its skeleton turns to a corner there: index of a point
    from that end, place and direction onwards."""

    line: Line
    side: int
    index: int
    place: Floats
    ahead: Floats


def join_overpasses(graph: Graph, width: float, shape: tuple[int, ...]) -> None:
    """Join dead ends that face each other across a road, without a junction, in place.

    `width`: usual width of roads in the picture (h, w), pixels.
    """
    seen = (_end(graph.lines[end.line], end.side, width) for end in dead_ends(graph, shape))
    ends = [end for end in seen if end is not None]
    used: set[int] = set()
    for _, i, j in sorted(_facing_pairs(ends, (_SPAN + 2 * _HOOK) * width)):
        a, b = ends[i], ends[j]
        if not {i, j} & used and any(_crosses(x.points, a.place, b.place) for x in graph.lines):
            used |= {i, j}
            start, end = _cut(graph, a), _cut(graph, b)
            count = max(2, round(float(np.hypot(*(b.place - a.place)))))
            graph.lines.append(Line(start, end, np.linspace(a.place, b.place, count), 1.0))
    if used:
        join(graph)


def _facing_pairs(ends: list[_End], most: float) -> Iterator[tuple[float, int, int]]:
    """The ends that face each other, at most `most` pixels apart: their distance, and both indices,
    the larger one first."""
    if not ends:
        return
    tree = cKDTree(np.array([end.place for end in ends]))
    for j, i in tree.query_pairs(1.001 * most):
        if _face(ends[i], ends[j], most):
            yield float(np.hypot(*(ends[j].place - ends[i].place))), i, j


def _end(line: Line, side: int, width: float) -> _End | None:
    """An end of a line; None if the line is too short to tell where it goes."""
    points = line.points if side == 0 else line.points[::-1]
    away = np.hypot(*(points - points[0]).T)
    hook, far = (int(np.argmax(away >= share * width)) for share in (_HOOK, _HOOK + _SEEN))
    if not 0 < hook < far:
        return None
    ahead = points[hook] - points[far]
    return _End(line, side, hook, points[hook], ahead / max(1e-9, float(np.hypot(*ahead))))


def _cut(graph: Graph, end: _End) -> int:
    """Let a line end where it is seen to, in place; its node there."""
    line = end.line
    if end.side == 0:
        line.points, node = line.points[end.index :], line.start
    else:
        line.points, node = line.points[: len(line.points) - end.index], line.end
    graph.nodes[node] = end.place
    return node


def _face(a: _End, b: _End, most: float) -> bool:
    way = b.place - a.place
    away = float(np.hypot(*way))
    if not 0 < away <= most:
        return False
    return bool(min(a.ahead @ way, -(b.ahead @ way)) >= _STRAIGHT * away)


def _crosses(points: Floats, start: Floats, end: Floats) -> bool:
    """Whether a line (n, 2) crosses the middle of the way between two places, not along it."""
    way = end - start
    away = float(np.hypot(*way))
    ahead = way / away
    off = points - start
    along, aside = off @ ahead, off[:, 0] * ahead[1] - off[:, 1] * ahead[0]
    first = np.flatnonzero((aside[:-1] < 0) != (aside[1:] < 0))
    for index in first.tolist():
        share = aside[index] / (aside[index] - aside[index + 1])
        place = along[index] + share * (along[index + 1] - along[index])
        low, high = max(0, index - 4), min(len(points) - 1, index + 5)
        step = points[high] - points[low]
        sine = abs(aside[high] - aside[low]) / max(1e-9, float(np.hypot(*step)))
        if _MIDDLE[0] * away < place < _MIDDLE[1] * away and sine >= _ACROSS:
            return True
    return False
