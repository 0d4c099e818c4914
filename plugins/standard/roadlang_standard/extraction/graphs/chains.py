"""Roads that run straight on through junctions: the order in which lines are smoothed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from roadlang.geometry import Floats

from .graph import Graph, Line

_TURN = np.deg2rad(20)
"""Lines that turn by more at a junction end there; they do not run straight through it."""


@dataclass
class LineChain:
    """Lines one after another, each with the way it is run through.

    A `closed` one goes straight on from its last line to its first.
    """

    parts: list[tuple[Line, bool]]
    closed: bool = False

    @property
    def nodes(self) -> list[int]:
        """Node ids from end to end."""
        first, forward = self.parts[0]
        ids = [first.start if forward else first.end]
        return ids + [line.end if ahead else line.start for line, ahead in self.parts]

    @property
    def length(self) -> float:
        """Pixels."""
        return sum(line.length for line, _ in self.parts)


def chains(graph: Graph, look: float) -> list[LineChain]:
    """All lines in chains that go straight on at nodes, longest chain first.

    `look` is how far from the node the direction of a line is taken, in pixels.
    """
    follow = _partners(graph, look)
    left = {id(line) for line in graph.lines}
    degree = graph.degree()
    found = []
    for line in sorted(graph.lines, key=lambda item: -item.length):
        if id(line) in left:
            left.discard(id(line))
            parts = [(line, True), *_onward(line, 1, follow, left)]
            last, ahead = parts[-1]
            beyond = follow.get((id(last), 1 if ahead else 0))
            closed = beyond is not None and beyond[0] is line and beyond[1] == 0
            closed |= line.closed and degree[line.start] == 2  # begins anywhere, at a corner too
            if not closed:
                back = _onward(line, 0, follow, left)
                parts = [(part, not ahead) for part, ahead in reversed(back)] + parts
            found.append(LineChain(parts, closed))
    return sorted(found, key=lambda chain: -chain.length)


def _onward(
    line: Line, side: int, follow: dict[tuple[int, int], tuple[Line, int]], left: set[int]
) -> list[tuple[Line, bool]]:
    parts = []
    while (id(line), side) in follow:
        line, entered = follow[id(line), side]  # a loop that goes straight on is its own
        if id(line) not in left:
            break
        left.discard(id(line))
        parts.append((line, entered == 0))
        side = 1 - entered
    return parts


def _partners(graph: Graph, look: float) -> dict[tuple[int, int], tuple[Line, int]]:
    ends: dict[int, list[tuple[Line, int]]] = {}
    for line in graph.lines:
        for side, node in ((0, line.start), (1, line.end)):
            ends.setdefault(node, []).append((line, side))
    follow: dict[tuple[int, int], tuple[Line, int]] = {}
    for there in ends.values():
        if len(there) < 2:
            continue
        meeting = [(*end, heading(*end, look)) for end in there]
        pairs = [
            (turn(a[2], b[2]), i, j)
            for i, a in enumerate(meeting)
            for j, b in enumerate(meeting[:i])
        ]
        used: set[int] = set()
        for angle, i, j in sorted(pairs):
            if angle < _TURN and i not in used and j not in used:
                used |= {i, j}
                (a, side_a, _), (b, side_b, _) = meeting[i], meeting[j]
                follow[id(a), side_a] = (b, side_b)
                follow[id(b), side_b] = (a, side_a)
    return follow


def heading(line: Line, side: int, look: float) -> Floats:
    """Unit vector in which a line leaves its end (0 start, 1 end), carried back to the end along
    its bend; seen beyond half of `look` pixels, where the junction does not bend it."""
    points = line.points if side == 0 else line.points[::-1]
    away = np.append(0.0, np.cumsum(np.hypot(*np.diff(points, axis=0).T)))
    chosen = (away >= 0.5 * look) & (away <= min(3.5 * look, away[-1] - 0.5 * look))
    seen = away[chosen]
    if len(seen) < 6 or seen[-1] - seen[0] < max(0.8 * look, 8.0):
        return direction(line, side, look)
    middle, half = (seen[-1] + seen[0]) / 2, (seen[-1] - seen[0]) / 2
    share = (seen - middle) / half  # -1 to 1: else the parabola's terms are hard to tell apart
    terms = np.column_stack([np.ones(len(share)), share, share**2])
    _, slope, bend = np.linalg.lstsq(terms, points[chosen])[0]
    first = slope - 2 * bend * middle / half
    return np.asarray(first / max(1e-9, float(np.hypot(*first))))


def direction(line: Line, side: int, look: float) -> Floats:
    """Unit vector in which a line leaves its end (0 start, 1 end), seen over `look` pixels."""
    points = line.points if side == 0 else line.points[::-1]
    away = np.cumsum(np.hypot(*np.diff(points, axis=0).T))
    last = min(int(np.searchsorted(away, look)) + 1, len(points) - 1)
    first = min(int(np.searchsorted(away, 0.35 * look)) + 1, last - 1) if last > 1 else 0
    step = points[last] - points[first]
    return np.asarray(step / max(1e-9, float(np.hypot(*step))))


def turn(a: Floats, b: Floats) -> float:
    """Radians between leaving in a direction and coming from another, 0 if straight on."""
    return float(np.arccos(np.clip(-(a @ b), -1, 1)))
