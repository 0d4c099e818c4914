"""What is drawn about the roads: names, and with a thinner pen arrows, scale bars, a frame."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..masks.skeleton import widths_across
from .graph import Graph, Line
from .graph_cleanup import at_border, components, join

_LONG, _SHORT = 0.6, 0.4
"""In shorter sides of the picture: connected roads are at least `_LONG` in length, names and arrows
shorter than `_SHORT`."""
_THIN = 0.55
"""Maximum width of the lines of names, arrows and frames, as a share of the width of the widest
road."""
_WORD, _CURLED, _WORDS = 0.2, 1.6, 0.2
"""Names may be as thick as the roads: they extend over less than `_WORD` of the picture's shorter
side, their lines are at least `_CURLED` times as long as that, and all of them together are at most
`_WORDS` of the longest connected roads in length: on a page of text a rule is no road."""
_ARROW, _HANGING, _AT_END = 0.25, 0.2, 0.25
"""Arrows that touch a road are shorter than `_ARROW` of the picture's shorter side. On `_AT_END` of
their length, away from the road, they are thinner than `_HANGING` of the widest road."""
_AT_BORDER = 4.0
"""Distance from the border, in pixels, within which a line leaves the picture."""
_RIM = 0.04
"""A frame is within this distance of the border, in shorter sides of the picture, ..."""
_AROUND = 0.7
"""along at least this share of it."""


def drop_thin_strokes(graph: Graph, inner: NDArray[np.float32]) -> int:
    """Forget a frame, words, and short parts that are thinner than the roads, in place; how many.

    `inner` (h, w) is how far pixels of the mask are from its edge.
    """
    side = min(inner.shape)
    _drop_frame(graph, inner)
    roads = [_width(part, inner) for part, length in _parts(graph) if length >= _LONG * side]
    if not roads:
        return 0
    touching = _drop_touching(graph, inner)
    parts = _parts(graph)
    longest = max((length for _, length in parts), default=0.0)
    thin: list[list[Line]] = []
    words: list[tuple[list[Line], float]] = []
    for part, length in parts if len(parts) > 1 else ():
        if length >= _SHORT * side or _leaves(part, inner.shape):
            continue
        if _width(part, inner) < _THIN * max(roads):
            thin.append(part)
        elif _is_word(part, length, side):
            words.append((part, length))
    few = sum(length for _, length in words) <= _WORDS * longest
    doomed = [*thin, *(part for part, _ in words if few)]
    gone = {id(line) for part in doomed for line in part}
    graph.lines = [line for line in graph.lines if id(line) not in gone]
    graph.drop_lonely()
    return len(doomed) + touching


def _parts(graph: Graph) -> list[tuple[list[Line], float]]:
    """What hangs together, and how long that is."""
    return [(part, sum(line.length for line in part)) for part in components(graph)]


def _is_word(part: list[Line], length: float, side: int) -> bool:
    """Whether lines that hang together are letters: small, and curled up."""
    extent = float(np.ptp(np.concatenate([line.points for line in part]), axis=0).max())
    return extent < _WORD * side and length >= _CURLED * extent


def _drop_touching(graph: Graph, inner: NDArray[np.float32]) -> int:
    """Forget short strokes, far thinner than the widest road, that touch roads in one place, in
    place; how many."""
    widths = [(_widths([line], inner, (0.5, _AT_END)), line) for line in graph.lines]
    most = _HANGING * max(usual for (usual, _), _ in widths)
    thin = [line for (_, at_end), line in widths if at_end < most]
    chosen = {id(line) for line in thin}
    others = [line for line in graph.lines if id(line) not in chosen]
    on_roads = {node for line in others for node in (line.start, line.end)}
    gone: set[int] = set()
    strokes = components(Graph(graph.nodes, thin))
    for stroke in strokes:
        touched = {node for line in stroke for node in (line.start, line.end)} & on_roads
        short = sum(line.length for line in stroke) < _ARROW * min(inner.shape)
        if len(touched) == 1 and short and not _leaves(stroke, inner.shape):
            gone |= {id(line) for line in stroke}
    if gone:
        graph.lines = [line for line in graph.lines if id(line) not in gone]
        join(graph)
    return len(gone)


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
    return _widths(lines, inner, (0.5,))[0]


def _widths(
    lines: list[Line], inner: NDArray[np.float32], shares: tuple[float, ...]
) -> list[float]:
    """The widths that such shares of lines are thinner than, pixels."""
    points = np.concatenate([line.points for line in lines])
    last = (inner.shape[1] - 1, inner.shape[0] - 1)
    columns, rows = np.clip(np.round(points).astype(int), 0, last).T
    return widths_across(inner[rows, columns], shares)
