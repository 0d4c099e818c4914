"""What is drawn about the roads with a thinner pen: names, arrows, scale bars, a frame."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .graph import Graph, Line
from .graph_cleanup import at_border, components, join

_LONG, _SHORT = 0.6, 0.4
"""Shorter sides of the picture: connected roads are longer, names and arrows shorter."""
_THIN = 0.55
"""Names, arrows and frames are drawn with less than this share of the widest road's width."""
_AT_BORDER = 4.0
"""Pixels from the border at which what is drawn leaves the picture."""
_RIM = 0.04
"""A frame is so near the border, in shorter sides of the picture, ..."""
_AROUND = 0.7
"""and along so much of it."""


def drop_thin_strokes(graph: Graph, inner: NDArray[np.float32]) -> int:
    """Forget a frame, and short parts that are thinner than the roads, in place; how many parts.

    `inner` (h, w) is how far pixels of the mask are from its edge.
    """
    side = min(inner.shape)
    _drop_frame(graph, inner)
    parts = [(part, sum(line.length for line in part)) for part in components(graph)]
    roads = [_width(part, inner) for part, length in parts if length >= _LONG * side]
    if len(parts) < 2 or not roads:
        return 0
    doomed = [
        part
        for part, length in parts
        if length < _SHORT * side
        and _width(part, inner) < _THIN * max(roads)
        and not _leaves(part, inner.shape)
    ]
    gone = {id(line) for part in doomed for line in part}
    graph.lines = [line for line in graph.lines if id(line) not in gone]
    graph.drop_lonely()
    return len(doomed)


def _drop_frame(graph: Graph, inner: NDArray[np.float32]) -> None:
    height, width = inner.shape
    margin = _RIM * min(height, width)
    rim = [line for line in graph.lines if _is_along_border(line, inner.shape, margin)]
    chosen = {id(line) for line in rim}
    others = [line for line in graph.lines if id(line) not in chosen]
    around = 2 * (height + width - 4 * margin)
    if not others or sum(line.length for line in rim) < _AROUND * around:
        return
    if _width(rim, inner) < _THIN * _width(others, inner):
        graph.lines = others
        join(graph)


def _is_along_border(line: Line, shape: tuple[int, ...], margin: float) -> bool:
    every = max(1, len(line.points) // 50)
    return all(at_border(point, shape, margin) for point in line.points[::every])


def _leaves(part: list[Line], shape: tuple[int, ...]) -> bool:
    """Whether an end of it is at the border of the picture."""
    ends = [end for line in part for end in (line.points[0], line.points[-1])]
    return any(at_border(end, shape, _AT_BORDER) for end in ends)


def _width(lines: list[Line], inner: NDArray[np.float32]) -> float:
    """The usual width of lines, pixels."""
    points = np.concatenate([line.points for line in lines])
    last = (inner.shape[1] - 1, inner.shape[0] - 1)
    columns, rows = np.clip(np.round(points).astype(int), 0, last).T
    return 2 * float(np.median(inner[rows, columns])) - 1
