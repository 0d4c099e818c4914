"""Where roads end within the picture, and which of these ends face each other."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from roadlang.geometry import Floats

from .chains import direction
from .graph import Graph
from .graph_cleanup import at_border

_FACING = 0.6
"""Least cosine between a dead end's direction and the way to what it faces."""
_IN_LINE = 0.9
"""Least cosine between the directions of ends in one line and the way between them."""
_TRUST, TRUST_ALIGNED = 0.4, 0.15
"""Shares of its cost that a bridge counts: between facing ends, and ends in one line."""


@dataclass(frozen=True)
class DeadEnd:
    """Where a line ends: node, place, direction onwards, the line's index and its side there."""

    node: int
    place: Floats
    ahead: Floats
    line: int
    side: int


def dead_ends(graph: Graph, shape: tuple[int, ...]) -> list[DeadEnd]:
    """Where roads end within the picture (h, w)."""
    degree = graph.degree()
    return [
        dead_end(graph, index, side)
        for index, line in enumerate(graph.lines)
        for side, node in ((0, line.start), (1, line.end))
        if degree[node] == 1 and not at_border(graph.nodes[node], (shape[0], shape[1]), 6.0)
    ]


def dead_end(graph: Graph, index: int, side: int) -> DeadEnd:
    """The start (side 0) or end (1) of a line as a dead end."""
    line = graph.lines[index]
    node = line.start if side == 0 else line.end
    return DeadEnd(node, graph.nodes[node], -direction(line, side, 16.0), index, side)


def facing(ends: list[DeadEnd], distance: float) -> Iterator[list[tuple[Floats, float]]]:
    """For each dead end those that it runs toward and that run toward it, with the share they
    count."""
    if not ends:
        return
    tree = cKDTree(np.array([end.place for end in ends]))
    for end in ends:
        near = tree.query_ball_point(end.place, 1.001 * distance, return_sorted=True)
        yield _facing_one(end, [ends[index] for index in near], distance)


def _facing_one(end: DeadEnd, near: list[DeadEnd], distance: float) -> list[tuple[Floats, float]]:
    """Those of the dead ends near one that face it, as `facing`."""
    faced = []
    for other in near:
        step = other.place - end.place
        away = float(np.hypot(*step))
        if other.node == end.node or not 0 < away <= distance:
            continue
        aligned = min(end.ahead @ step, other.ahead @ -step) / away
        if aligned > _FACING:
            faced.append((other.place, TRUST_ALIGNED if aligned > _IN_LINE else _TRUST))
    return faced
