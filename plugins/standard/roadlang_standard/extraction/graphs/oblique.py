"""Two roads that cross at an acute angle: thinning makes two junctions of their crossing."""

from __future__ import annotations

import numpy as np

from .chains import heading, turn
from .graph import Graph, Line
from .graph_cleanup import contract_lines

_LONGEST = 5.5
"""Widths: roads that cross at 20 degrees lie over one another for w / sin(10 degrees)."""
_STRAIGHT = np.deg2rad(12.0)
_LEAST_SKEW, _MOST_SKEW = np.deg2rad(12.0), np.deg2rad(100.0)
"""Between the two roads where they leave one end. Two T junctions joined by a short road, as in an
H, have theirs in opposite directions there."""


def join_oblique_crossings(graph: Graph, width: float) -> None:
    """Make one node of two that a short line joins where two roads go straight on, in place."""
    degree = graph.degree()
    at: dict[int, list[tuple[Line, int]]] = {}
    for line in graph.lines:
        at.setdefault(line.start, []).append((line, 0))
        at.setdefault(line.end, []).append((line, 1))
    short = [
        line
        for line in graph.lines
        if not line.closed
        and degree[line.start] == degree[line.end] == 3
        and line.length < _LONGEST * width + 4
        and _crosses(line, at, 4.0 * width + 8)
    ]
    used: set[int] = set()
    chosen = []
    for line in sorted(short, key=lambda item: item.length):
        if not {line.start, line.end} & used:
            used |= {line.start, line.end}
            chosen.append(line)
    if chosen:
        contract_lines(graph, chosen)


def _crosses(line: Line, at: dict[int, list[tuple[Line, int]]], look: float) -> bool:
    """Whether the roads at one end of a line go straight on in those at its other end."""
    near, far = ([end for end in at[node] if end[0] is not line] for node in (line.start, line.end))
    if len(near) != 2 or len(far) != 2 or any(a[0] is b[0] for a in near for b in far):
        return False
    before, after = ([heading(*end, look) for end in ends] for ends in (near, far))
    skew = np.pi - turn(before[0], before[1])
    straight = min(max(turn(before[0], after[i]), turn(before[1], after[1 - i])) for i in (0, 1))
    return bool(straight < _STRAIGHT and _LEAST_SKEW < skew < _MOST_SKEW)
