"""Short roads that thinning does not see, by their ends: the surface ends straight across there.

A branch that reaches hardly farther than the rounded corners of its junction is a bulge of the
surface, and thinning leaves no line in it. Its end is a straight edge, about a road's width long,
between two right angles.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np

from roadlang.geometry import Booleans, Floats

from ..masks.mask_parts import is_inside
from .graph import Graph, Line

_NARROW, _WIDE = 0.7, 1.35
"""Least and greatest length of the end of a stub, from edge to edge, in widths of the road."""
_SIDE, _LEAST_SIDE = 0.12, 1.5
"""Least length of the two edges beside the end, in widths and in pixels."""
_TURN = np.cos(np.radians(65.0))
"""The edge turns by at least 65 degrees at both ends."""
_NEAREST, _FARTHEST = 0.85, 2.0
"""Distance from the end of a stub to the center line of its road, in widths: bays beside a road are
closer than `_NEAREST`, and stubs longer than `_FARTHEST` have a line of their own."""
_ASIDE = 0.45
"""Maximum lateral distance of that line from the axis of the stub, in widths."""
_KNOWN = 0.9
"""A dead end within this many widths of the end of a stub belongs to the stub."""
_SAME_NODE = 0.6
"""A stub that meets its road within this many widths of a node begins at the node."""


@dataclass(frozen=True)
class SquareEnd:
    """Where the surface ends straight across: the middle of its edge, and the way in, length 1."""

    middle: Floats
    inward: Floats


def add_square_stubs(graph: Graph, mask: Booleans, width: float) -> list[Line]:
    """Give stubs of the surface (h, w) that have no line one, from the road they branch off to half
    a width before their ends, in place. Returns the lines of all stubs. `width`: the usual one,
    pixels."""
    found: list[Line] = []
    for end in square_ends(mask, width):
        known = _line_to(graph, end, width)
        if known is not None:
            found.append(known)
            continue
        node = _branching(graph, end, width)
        if node is not None:
            last = end.middle + 0.5 * width * end.inward
            points = np.array([graph.nodes[node], last])
            found.append(Line(node, graph.add_node(last), points))
            graph.lines.append(found[-1])
    return found


def square_ends(mask: Booleans, width: float) -> Iterator[SquareEnd]:
    """The straight ends of a surface, in the order of its outlines."""
    outlines, _ = cv2.findContours(mask.astype(np.uint8), cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    for outline in outlines:
        corners = cv2.approxPolyDP(outline, max(1.0, 0.06 * width), closed=True)[:, 0].astype(float)
        if len(corners) < 4:
            continue
        edges = np.roll(corners, -1, axis=0) - corners
        lengths = np.hypot(*edges.T)
        ahead = edges / lengths[:, None]
        before, after = np.roll(ahead, 1, axis=0), np.roll(ahead, -1, axis=0)
        # The pixels at both ends of an edge belong to the surface.
        is_end = (lengths + 1 > _NARROW * width) & (lengths + 1 < _WIDE * width)
        side = np.minimum(np.roll(lengths, 1), np.roll(lengths, -1))
        is_end &= side + 1 > max(_SIDE * width, _LEAST_SIDE)
        is_end &= (np.abs((before * ahead).sum(axis=1)) < _TURN) & (
            (before * after).sum(axis=1) < 0
        )
        for i in np.flatnonzero(is_end):
            inward = after[i] - before[i]
            inward /= np.hypot(*inward)
            middle = corners[i] + edges[i] / 2 - 0.5 * inward
            if is_inside(mask, middle + 0.3 * width * inward):
                yield SquareEnd(middle, inward)


def _line_to(graph: Graph, end: SquareEnd, width: float) -> Line | None:
    """The line that has its dead end there, if any."""
    degree, (x, y) = graph.degree(), end.middle
    for line in graph.lines:
        for node in (line.start, line.end):
            if degree[node] == 1:
                at = graph.nodes[node]
                if np.hypot(at[0] - x, at[1] - y) < _KNOWN * width:
                    return line
    return None


def _branching(graph: Graph, end: SquareEnd, width: float) -> int | None:
    """The node where a stub branches off, new if need be; None where no line is ahead of it."""
    best, nearest = None, _FARTHEST * width
    across = np.array([-end.inward[1], end.inward[0]])
    for line in graph.lines:
        away = line.points - end.middle
        along, aside = away @ end.inward, np.abs(away @ across)
        ahead = np.where((aside < _ASIDE * width) & (along > 0), along, np.inf)
        at = int(ahead.argmin())
        if ahead[at] < nearest:
            best, nearest = (line, at), float(ahead[at])
    if best is None or nearest < _NEAREST * width:
        return None
    line, at = best
    nodes = [n for n, count in graph.degree().items() if count > 1]
    distances = [float(np.hypot(*(graph.nodes[n] - line.points[at]))) for n in nodes]
    if distances and min(distances) < _SAME_NODE * width:
        return nodes[int(np.argmin(distances))]
    if at in (0, len(line.points) - 1):
        return line.start if at == 0 else line.end
    return _split(graph, line, at)


def _split(graph: Graph, line: Line, at: int) -> int:
    """A new node at a point of a line."""
    node = graph.add_node(line.points[at])
    first, last = line.points[: at + 1], line.points[at:]
    graph.lines = [other for other in graph.lines if other is not line]
    if line.closed and line.start not in {n for o in graph.lines for n in (o.start, o.end)}:
        graph.lines.append(Line(node, node, np.vstack([last, first[1:]]), line.linked))
        del graph.nodes[line.start]
    else:
        graph.lines += [Line(line.start, node, first, line.linked),
                        Line(node, line.end, last, line.linked)]  # fmt: skip
    return node
