"""Which dead ends of a skeleton are short roads, and which only run into a corner of the surface.

The largest circle inside a road keeps its size up to the road's end, whose corners it cannot reach:
on a branch into a corner it shrinks at once.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans, Floats

from ..masks.mask_parts import is_inside
from .chains import direction
from .graph import Graph, Line
from .graph_cleanup import at_border, join

_WIDE = 0.8
"""Least width of a road, as a share of the usual width."""
_CORNER, _STUB = 0.25, 0.5
"""A branch that is as wide as a road over less than `_CORNER` widths runs into a corner of the
surface; over at least `_STUB` widths, it is a short road."""
_BEFORE_EDGE, _ACROSS = 0.15, 0.4
"""The shape of an end is measured `_BEFORE_EDGE` widths before the edge of the surface, `_ACROSS`
widths to both sides: there, a round end reaches at most 0.36 widths to each side, and a square end
0.5."""
_LOOKS = (1.5, 1.0, 0.7)
"""Widths over which the direction of a dead end is measured, longest first: short ones turn where
they branch off."""


def drop_corners(graph: Graph, inner: NDArray[np.float32], width: float) -> None:
    """Cut the branches that run into corners, in place. `inner` (h, w): distance to the edge."""
    while True:
        corners = {
            id(line)
            for line, reach in _dead_ends(graph, inner, width)
            if reach < _CORNER * width and line.length < 1.1 * width
        }
        if not corners:
            return
        graph.lines = [line for line in graph.lines if id(line) not in corners]
        join(graph)


def drop_border_forks(graph: Graph, inner: NDArray[np.float32]) -> None:
    """Cut what forks where wide roads leave the picture, in place.

    Both branches run into corners of the surface, and neither is longer than the road is wide
    there. `inner` as for `drop_corners`.
    """
    degree = graph.degree()
    forks: dict[int, list[Line]] = {}
    for line in graph.lines:
        for node, other in ((line.start, line.end), (line.end, line.start)):
            if degree[node] != 3 or degree[other] != 1:
                continue
            x, y = np.round(graph.nodes[node]).astype(int)
            reach = 2 * float(inner[y, x])
            if line.length < reach and at_border(graph.nodes[other], inner.shape, 0.5 * reach):
                forks.setdefault(node, []).append(line)
    doomed = {id(line) for lines in forks.values() if len(lines) == 2 for line in lines}
    graph.lines = [line for line in graph.lines if id(line) not in doomed]
    graph.drop_lonely()


def stubs(graph: Graph, inner: NDArray[np.float32], width: float) -> list[Line]:
    """The dead ends, however short, that are as wide as a road for half a width from where they
    branch off."""
    return [line for line, reach in _dead_ends(graph, inner, width) if reach >= _STUB * width]


def _dead_ends(
    graph: Graph, inner: NDArray[np.float32], width: float
) -> Iterator[tuple[Line, float]]:
    """Dead ends at junctions, and how far from there they are as wide as a road, in pixels."""
    degree = graph.degree()
    for line in graph.lines:
        ends = sorted((degree[line.start], degree[line.end]))
        if line.closed or ends[0] != 1 or ends[1] < 3:
            continue
        points = line.points if degree[line.start] > 1 else line.points[::-1]
        along = np.r_[0.0, np.cumsum(np.hypot(*np.diff(points, axis=0).T))]
        columns, rows = np.round(points).astype(int).T
        tall, wide = inner.shape
        radii = inner[np.clip(rows, 0, tall - 1), np.clip(columns, 0, wide - 1)]
        yield line, float(along[2 * radii - 1 >= _WIDE * width].max(initial=0.0))


def lengthen_square_ends(graph: Graph, mask: Booleans, width: float) -> None:
    """Move dead ends on to the edge of the surface where that ends straight across, in place.

    A skeleton ends half a width earlier. There ends what is drawn with a round pen, too.
    """
    degree = graph.degree()
    for line in graph.lines:
        for side, node in ((0, line.start), (1, line.end)):
            if line.closed or degree[node] != 1:
                continue
            looks = (direction(line, side, look * width) for look in _LOOKS)
            ends = (_square_end(mask, graph.nodes[node], -away, width) for away in looks)
            end = next((found for found in ends if found is not None), None)
            if end is not None:
                graph.nodes[node] = end
                parts = (end[None], line.points) if side == 0 else (line.points, end[None])
                line.points = np.concatenate(parts)


def _square_end(mask: Booleans, place: Floats, ahead: Floats, width: float) -> Floats | None:
    """Where the surface ends ahead of a place, straight across; else None."""
    rest = _distance_to_edge(mask, place, ahead, width)
    if rest <= 0:
        return None
    across = np.array([-ahead[1], ahead[0]]) * _ACROSS * width
    for before in (_BEFORE_EDGE * rest, _BEFORE_EDGE * width):
        near_edge = place + (rest - before) * ahead
        if not (is_inside(mask, near_edge + across) and is_inside(mask, near_edge - across)):
            return None
    return place + rest * ahead


def _distance_to_edge(mask: Booleans, place: Floats, ahead: Floats, width: float) -> float:
    """Pixels to the edge of the surface, 0 where that is farther than a width."""
    steps = np.arange(0.5, width + 1.0, 0.5)
    x, y = np.round(place + steps[:, None] * ahead).astype(int).T
    inside = (x >= 0) & (x < mask.shape[1]) & (y >= 0) & (y < mask.shape[0])
    inside[inside] = mask[y[inside], x[inside]]
    return 0.0 if inside.all() else float(steps[int(inside.argmin())]) - 0.5
