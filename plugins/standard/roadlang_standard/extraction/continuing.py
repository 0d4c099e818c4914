"""Carry sure roads on along fainter evidence that goes on where they end: through shade."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from .clean import join, prune
from .graph import Floats, Graph, Line, trace
from .hysteresis import hysteresis
from .linking import DeadEnd, dead_ends
from .skeleton import skeleton

Layer = NDArray[np.float32]
_ONWARD = 0.7
"""Least cosine between a dead end, the way to a fainter line, and that line."""


@dataclass(frozen=True)
class Onward:
    """A fainter line that goes on from a dead end; `side` is its near end; pixels between."""

    end: DeadEnd
    line: Line
    side: int
    gap: float


def carry_on(
    graph: Graph, score: Layer, levels: tuple[float, float], width: float, reach: float
) -> None:
    """Add to the graph, in place, the fainter lines that go straight on from its dead ends.

    `levels` are the strong and the weak one for them, `width` the usual width of a road; gaps may
    be up to `reach` pixels. What joins a road from the side is left out: drives look like that.
    """
    ends = dead_ends(graph, score.shape)
    if not ends:
        return
    faint = _fainter(graph, score, levels, width)
    while ends:
        found = [onward for end in ends for onward in _onwards(end, faint, width, reach)]
        if not found:
            break
        chosen = min(found, key=lambda onward: onward.gap)
        faint.lines = [line for line in faint.lines if line is not chosen.line]
        ends = [end for end in ends if end.node != chosen.end.node]
        _add(graph, chosen)
        last = graph.lines[-1]
        ends += [end for end in dead_ends(graph, score.shape) if end.node == last.end]
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


def _onwards(end: DeadEnd, faint: Graph, width: float, reach: float) -> list[Onward]:
    found = []
    for line in faint.lines:
        for side, node in ((0, line.start), (1, line.end)):
            step = faint.nodes[node] - end.place
            gap = float(np.hypot(*step))
            if gap > reach:
                continue
            into = _into(line, side, 2 * width)
            turns = [end.ahead @ into]
            if gap > 2 * width:
                turns += [end.ahead @ step / gap, into @ step / gap]
            if min(turns) > _ONWARD:
                found.append(Onward(end, line, side, gap))
    return found


def _into(line: Line, side: int, look: float) -> Floats:
    """Unit vector from an end of a line into it."""
    points = line.points if side == 0 else line.points[::-1]
    away = np.hypot(*(points - points[0]).T)
    far = points[int(np.argmax(away >= look))] if away[-1] >= look else points[-1]
    step = far - points[0]
    return np.asarray(step / max(1e-9, float(np.hypot(*step))))


def _add(graph: Graph, onward: Onward) -> None:
    """The gap and the fainter line as one line from the dead end on."""
    points = onward.line.points if onward.side == 0 else onward.line.points[::-1]
    points = np.vstack([onward.end.place, points])
    far = graph.add_node(points[-1])
    whole = Line(onward.end.node, far, points)
    whole.linked = onward.gap / max(1e-9, whole.length)
    graph.lines.append(whole)
