"""Strokes that branch off a line and end between two lines: these are roads, such as a ring with
dead ends, and no edges of one."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..graphs.dead_ends import dead_ends
from ..graphs.graph_cleanup import prune
from ..graphs.tracing import trace
from ..masks.mask_parts import window_around
from ..masks.skeleton import skeleton

_BESIDE, _MOST = 0.1, 0.15
"""If more than `_BESIDE` of the lines have road on both sides, their strokes are examined; at most
`_MOST` of the length of true edges is in loose strokes."""


def are_loose(ink: Booleans, road: NDArray[np.uint8], pen: float) -> bool:
    """Whether much of the ink (h, w), `pen` pixels thick, branches off lines and ends within the
    `road` (h, w) that may lie between these."""
    window = window_around(road, 2 * round(pen) + 2)
    ink, road = np.ascontiguousarray(ink[window]), np.ascontiguousarray(road[window])
    size = 2 * int(np.ceil(0.5 * pen)) + 1
    closed = cv2.morphologyEx(road, cv2.MORPH_CLOSE, np.ones((size, size), np.uint8)) > 0
    within = ink & closed
    if np.count_nonzero(within) < _BESIDE * np.count_nonzero(ink):
        return False
    graph = trace(skeleton(ink))
    prune(graph, 2 * pen, (ink.shape[0], ink.shape[1]))
    degree = graph.degree()
    ends = [
        (graph.lines[end.line], end.place.round().astype(int))
        for end in dead_ends(graph, ink.shape)
    ]
    loose = sum(
        line.length
        for line, (x, y) in ends
        if max(degree[line.start], degree[line.end]) > 2 and closed[y, x]
    )
    return loose > _MOST * sum(line.length for line in graph.lines)
