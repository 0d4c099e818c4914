"""Which lines the evidence is worth keeping: mean evidence along them, and pruning by it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..curves.sampled import sampled
from ..curves.smoothing import resample
from .graph import Graph, Line
from .graph_cleanup import at_border, components, join

Layer = NDArray[np.float32]


def mean_evidence(line: Line, score: Layer) -> float:
    """Mean of the score (h, w) along a line."""
    at = resample(line.points, 2.0).astype(np.float32).reshape(1, -1, 2)
    return float(sampled(score, at[..., 0], at[..., 1]).mean())


def discounted_length(line: Line, score: Layer, floor: float) -> float:
    """Length in pixels, discounted by how far the evidence is above `floor`."""
    share = (mean_evidence(line, score) - floor) / (1 - floor)
    return line.length * float(np.clip(share, 0, 1))


def prune_by_discounted_length(graph: Graph, score: Layer, least: float, floor: float) -> None:
    """Cut dead ends worth less than `least` pixels, least worthy first, in place."""
    shape = (score.shape[0], score.shape[1])
    values: dict[int, tuple[Line, float]] = {}  # with the lines: or another may get an id
    while True:
        degree = graph.degree()
        doomed: list[tuple[float, int]] = []
        for index, line in enumerate(graph.lines):
            free = [node for node in (line.start, line.end) if degree[node] == 1]
            if line.closed or len(free) != 1:
                continue
            allowance = 0.5 if at_border(graph.nodes[free[0]], shape, 6.0) else 1.0
            if id(line) not in values:
                values[id(line)] = (line, discounted_length(line, score, floor))
            value = values[id(line)][1]
            if value < allowance * least:
                doomed.append((value, index))
        if not doomed:
            break
        chosen = _apart(graph, doomed)
        graph.lines = [line for index, line in enumerate(graph.lines) if index not in chosen]
        join(graph)
    graph.drop_lonely()


def _apart(graph: Graph, doomed: list[tuple[float, int]]) -> set[int]:
    """The least worthy dead ends, one a node: what goes on through the node is judged anew."""
    chosen: set[int] = set()
    touched: set[int] = set()
    for _, index in sorted(doomed):
        line = graph.lines[index]
        if not {line.start, line.end} & touched:
            touched |= {line.start, line.end}
            chosen.add(index)
    return chosen


def drop_unworthy(graph: Graph, score: Layer, least: float, floor: float) -> None:
    """Forget connected parts worth less than `least` pixels in all, in place.

    Half of that will do for a part that comes in at the picture's edge and leaves there: the rest
    of it lies outside.
    """
    shape = (score.shape[0], score.shape[1])
    worthy = set()
    for part in components(graph):
        ends = {node for line in part for node in (line.start, line.end)}
        crossing = sum(at_border(graph.nodes[node], shape, 6.0) for node in ends) > 1
        if (
            sum(discounted_length(x, score, floor) for x in part)
            >= (0.5 if crossing else 1.0) * least
        ):
            worthy |= {id(line) for line in part}
    graph.lines = [line for line in graph.lines if id(line) in worthy]
    graph.drop_lonely()
