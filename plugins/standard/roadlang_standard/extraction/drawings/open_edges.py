"""Two edge lines of a road that end side by side: the road ends there."""

from __future__ import annotations

import cv2
import numpy as np

from roadlang.geometry import Booleans

from ..graphs.dead_ends import DeadEnd, dead_ends
from ..graphs.graph_cleanup import prune
from ..graphs.tracing import trace
from ..masks.skeleton import skeleton

_WIDEST = 0.25
"""Lines farther apart than this share of the picture's shorter side are not edges of one road."""
_MOST_ENDS = 64
"""Pictures with more loose ends have hatching or text."""
_PARALLEL, _ABREAST = 0.7, 0.6
"""Least cosine between the directions of the two ends, and most between either and the way from one
to the other."""


def with_closed_ends(ink: Booleans, pen: float) -> Booleans | None:
    """The lines (h, w), `pen` pixels thick, with a stroke across each open end of a road.

    None where no two lines end abreast.
    """
    graph = trace(skeleton(ink))
    prune(graph, 2 * pen, (ink.shape[0], ink.shape[1]))
    ends = dead_ends(graph, ink.shape)
    if len(ends) > _MOST_ENDS:
        return None
    pairs = [
        (float(np.hypot(*(b.place - a.place))), i, j)
        for i, a in enumerate(ends)
        for j, b in enumerate(ends[:i])
        if _are_abreast(a, b, _WIDEST * min(ink.shape))
    ]
    if not pairs:
        return None
    closed = ink.astype(np.uint8)
    used: set[int] = set()
    for _, i, j in sorted(pairs):
        if not {i, j} & used:
            used |= {i, j}
            start, end = (tuple(np.round(ends[k].place).astype(int).tolist()) for k in (i, j))
            cv2.line(closed, start, end, 1, max(1, round(pen)))
    return np.asarray(closed > 0)


def _are_abreast(a: DeadEnd, b: DeadEnd, widest: float) -> bool:
    """Whether two lines run the same way and end side by side."""
    across = b.place - a.place
    away = float(np.hypot(*across))
    if not 0 < away <= widest or a.ahead @ b.ahead < _PARALLEL:
        return False
    return bool(max(abs(a.ahead @ across), abs(b.ahead @ across)) < _ABREAST * away)
