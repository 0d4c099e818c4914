"""Carry sure roads on along fainter evidence that goes on where they end: through shade."""

from __future__ import annotations

from dataclasses import dataclass, field
from heapq import heapify, heappop, heappush

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from roadlang.geometry import Floats

from ..masks.hysteresis import hysteresis
from ..masks.skeleton import skeleton
from .chains import direction
from .dead_ends import DeadEnd, dead_end, dead_ends
from .graph import Graph, Line
from .graph_cleanup import join, prune
from .tracing import trace

Layer = NDArray[np.float32]
_ONWARD = 0.7
"""Least cosine between a dead end, the way to a fainter line, and that line."""


@dataclass(frozen=True, order=True)
class Onward:
    """A fainter line that goes on from a dead end; `side` is its near end; pixels between."""

    gap: float
    end: DeadEnd = field(compare=False)
    line: Line = field(compare=False)
    side: int = field(compare=False)


def extend_dead_ends(
    graph: Graph, score: Layer, levels: tuple[float, float], width: float, distance: float
) -> None:
    """Add to the graph, in place, the fainter lines that go straight on from its dead ends.

    `levels` are the strong and the weak one for them, `width` the usual width of a road; gaps may
    be up to `distance` pixels. What joins a road from the side is left out: drives look like that.
    """
    ends = dead_ends(graph, score.shape)
    if not ends:
        return
    faint = _Faint(_fainter(graph, score, levels, width), width, distance)
    waiting = [onward for end in ends for onward in faint.onwards(end)]
    heapify(waiting)
    ended: set[int] = set()
    used: set[int] = set()
    while waiting:
        chosen = heappop(waiting)
        if chosen.end.node in ended or id(chosen.line) in used:
            continue
        ended.add(chosen.end.node)
        used.add(id(chosen.line))
        for onward in faint.onwards(_added(graph, chosen)):
            heappush(waiting, onward)
    join(graph)


def _fainter(graph: Graph, score: Layer, levels: tuple[float, float], width: float) -> Graph:
    """The lines of the fainter evidence that lies off the roads there are."""
    mask = hysteresis(score, *levels)
    near = np.zeros(mask.shape, np.uint8)
    thickness = max(1, round(2.4 * width))
    for line in graph.lines:
        at = [np.round(line.points * 16).astype(np.int32)]
        cv2.polylines(near, at, False, 1, thickness, cv2.LINE_8, 4)
    faint = trace(skeleton(mask & (near == 0)))
    prune(faint, 1.2 * width)
    join(faint)
    faint.lines = [line for line in faint.lines if not line.closed and line.length > 1.5 * width]
    return faint


class _Faint:
    """The fainter lines, found by where their ends lie."""

    def __init__(self, graph: Graph, width: float, distance: float) -> None:
        self.width, self.max_distance = width, distance
        self.tips = [(line, side) for line in graph.lines for side in (0, 1)]
        self.places = np.array([_tip(*tip) for tip in self.tips]).reshape(-1, 2)
        self.directions: dict[int, Floats] = {}
        self.tree = cKDTree(self.places)

    def onwards(self, end: DeadEnd) -> list[Onward]:
        """Those that go straight on: the end, the way across the gap and the line have one
        direction; the way across a gap of less than two widths says nothing."""
        near = np.sort(np.array(self.tree.query_ball_point(end.place, self.max_distance), int))
        if not len(near):
            return []
        across = self.places[near] - end.place
        into = np.array([self._direction(int(index)) for index in near])
        gaps = np.hypot(*across.T)
        way = across / np.maximum(gaps, 1e-9)[:, None]
        along = np.minimum(way @ end.ahead, (way * into).sum(axis=1))
        straight = (into @ end.ahead > _ONWARD) & ((gaps <= 2 * self.width) | (along > _ONWARD))
        return [
            Onward(float(gap), end, *self.tips[index])
            for gap, index in zip(gaps[straight], near[straight], strict=True)
        ]

    def _direction(self, index: int) -> Floats:
        """Of most tips it is never asked."""
        if index not in self.directions:
            self.directions[index] = direction(*self.tips[index], 2 * self.width)
        return self.directions[index]


def _tip(line: Line, side: int) -> Floats:
    return np.asarray(line.points[0] if side == 0 else line.points[-1])


def _added(graph: Graph, onward: Onward) -> DeadEnd:
    """Where the road ends now that the gap and the fainter line are one line of the graph."""
    points = onward.line.points if onward.side == 0 else onward.line.points[::-1]
    points = np.vstack([onward.end.place, points])
    line = Line(onward.end.node, graph.add_node(points[-1]), points)
    line.linked = onward.gap / max(1e-9, line.length)
    graph.lines.append(line)
    return dead_end(graph, len(graph.lines) - 1, 1)
