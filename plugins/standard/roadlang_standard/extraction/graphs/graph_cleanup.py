"""Tidy a traced graph: contract twin junctions, cut spurs, join what goes on, drop crumbs."""

from __future__ import annotations

from collections.abc import Collection, Container, Mapping

import numpy as np

from roadlang.geometry import Booleans, Floats

from .chains import direction
from .graph import Graph, Line

_ROUNDS = 12


def contract(graph: Graph, distance: float, places: Mapping[int, Floats] | None = None) -> None:
    """Make one node of junctions joined by a line shorter than `distance` pixels, in place, or
    whose `places`, if given, are nearer to each other than that.

    Shortest lines first, each node once a round, so that the cost stays that of a few passes.
    """
    for _ in range(_ROUNDS):
        degree = graph.degree()
        short = [
            (_apart_by(line, places), index)
            for index, line in enumerate(graph.lines)
            if not line.closed and degree[line.start] > 2 and degree[line.end] > 2
        ]
        bridges = _apart(graph, [item for item in short if item[0] < distance])
        if not bridges:
            return
        contract_lines(graph, bridges)


def _apart_by(line: Line, places: Mapping[int, Floats] | None) -> float:
    """Pixels between the ends of a line, along it or else between their places."""
    if places is None:
        return line.length
    return float(np.hypot(*(places[line.end] - places[line.start])))


def _apart(graph: Graph, lines: list[tuple[float, int]]) -> list[Line]:
    """Of lines given as (value, index) those of least value that share no node."""
    chosen: list[Line] = []
    touched: set[int] = set()
    for _, index in sorted(lines):
        line = graph.lines[index]
        if not {line.start, line.end} & touched:
            touched |= {line.start, line.end}
            chosen.append(line)
    return chosen


def contract_lines(graph: Graph, bridges: list[Line]) -> None:
    """Contract lines that share no node; what becomes a small loop by it goes as well."""
    removed = {id(line) for line in bridges}
    into: dict[int, int] = {}
    spans: dict[int, float] = {}
    for bridge in bridges:
        remaining, lost = bridge.start, bridge.end
        graph.nodes[remaining] = (graph.nodes[remaining] + graph.nodes[lost]) / 2
        del graph.nodes[lost]
        into[lost] = remaining
        spans[remaining] = bridge.length
    left = []
    for line in graph.lines:
        if id(line) in removed:
            continue
        line.start, line.end = into.get(line.start, line.start), into.get(line.end, line.end)
        if line.closed and line.length < 3 * spans.get(line.start, 0.0) + 6:
            continue
        line.points[0], line.points[-1] = graph.nodes[line.start], graph.nodes[line.end]
        left.append(line)
    graph.lines = left


def prune(
    graph: Graph,
    least: float,
    shape: tuple[int, int] | None = None,
    margin: float = 4.0,
    sure: Collection[Line] = (),
) -> None:
    """Cut dead ends below `least` pixels, shortest first, but at the border and `sure` ones.
    In place."""
    sure_ids = {id(line) for line in sure}
    while True:
        degree = graph.degree()
        spurs = [
            (line.length, index)
            for index, line in enumerate(graph.lines)
            if not line.closed
            and id(line) not in sure_ids
            and (degree[line.start] == 1) != (degree[line.end] == 1)
            and not at_border(
                graph.nodes[line.start if degree[line.start] == 1 else line.end], shape, margin
            )
        ]
        doomed = {id(line) for line in _apart(graph, [s for s in spurs if s[0] < least])}
        if not doomed:
            break
        graph.lines = [line for line in graph.lines if id(line) not in doomed]
        join(graph)
    graph.drop_lonely()


def drop_loops(graph: Graph, least: float) -> None:
    """Forget loops from a junction back to itself below `least` pixels, in place."""
    degree = graph.degree()
    graph.lines = [
        line
        for line in graph.lines
        if not (line.closed and degree[line.start] > 2 and line.length < least)
    ]
    join(graph)


def at_border(point: Floats, shape: tuple[int, ...] | None, margin: float) -> bool:
    """Whether a point lies within `margin` pixels of the picture's edge."""
    if shape is None:
        return False
    x, y = point
    return bool(x < margin or y < margin or x > shape[1] - 1 - margin or y > shape[0] - 1 - margin)


def join(graph: Graph) -> None:
    """Make one line of two that meet at a node where nothing else does, in place."""
    at: dict[int, dict[int, Line]] = {node: {} for node in graph.nodes}
    for line in graph.lines:
        at[line.start][id(line)] = line
        at[line.end][id(line)] = line
    left = {id(line): line for line in graph.lines}
    for node, count in graph.degree().items():
        if count != 2 or len(at[node]) != 2:
            continue
        first, second = at[node].values()
        joined = _joined(first, second, node)
        for old in (first, second):
            for end in (old.start, old.end):
                at[end].pop(id(old), None)
            del left[id(old)]
        left[id(joined)] = at[joined.start][id(joined)] = at[joined.end][id(joined)] = joined
    graph.lines = list(left.values())
    graph.drop_lonely()


def _joined(first: Line, second: Line, node: int) -> Line:
    a = first.points if first.end == node else first.points[::-1]
    b = second.points if second.start == node else second.points[::-1]
    start = first.start if first.end == node else first.end
    end = second.end if second.start == node else second.start
    bridged = first.linked * first.length + second.linked * second.length
    share = bridged / max(1e-9, first.length + second.length)
    return Line(start, end, np.vstack([a, b[1:]]), share)


def extend_to_border(
    graph: Graph,
    shape: tuple[int, int],
    distance: float,
    done: Container[int] = (),
    surface: Booleans | None = None,
) -> None:
    """Carry dead ends within `distance` pixels of the picture's edge straight on to it, in place,
    but for nodes that are there already (`done`), and those that end on the `surface` (h, w) before
    it is reached.

    Near the edge a skeleton turns toward the corner of its mask: that bit is cut off first.
    """
    degree = graph.degree()
    for line in graph.lines:
        for side, node in ((0, line.start), (1, line.end)):
            if (
                degree[node] != 1
                or node in done
                or not at_border(graph.nodes[node], shape, distance)
            ):
                continue
            points = line.points if side == 0 else line.points[::-1]
            points = _without_hook(points, distance)
            straight = Line(line.start, line.end, points)
            goal = _border_ahead(points[0], -direction(straight, 0, 2 * distance + 4), shape)
            if surface is not None and _off(points[0], goal, surface) > 0.5 * distance + 1:
                continue
            if np.hypot(*(goal - points[0])) <= 3.5 * distance:
                points = np.vstack([goal, points])
            line.points = points if side == 0 else points[::-1]
            graph.nodes[node] = points[0]


def _off(start: Floats, goal: Floats, surface: Booleans) -> float:
    """Pixels of the way between two places that are not on a surface (h, w)."""
    count = 2 + int(np.hypot(*(goal - start)))
    height, width = surface.shape
    way = np.round(np.linspace(start, goal, count)).astype(int)
    columns, rows = np.clip(way, 0, (width - 1, height - 1)).T
    return float((~surface[rows, columns]).sum())


def _without_hook(points: Floats, distance: float) -> Floats:
    """The line from where it is `distance` away from its start, if that leaves most of it."""
    away = np.hypot(*(points - points[0]).T)
    beyond = int(np.argmax(away >= distance))
    return points[beyond:] if 0 < beyond < len(points) / 2 else points


def _border_ahead(position: Floats, ahead: Floats, shape: tuple[int, int]) -> Floats:
    """Where a ray leaves the picture."""
    corner = np.array([shape[1], shape[0]]) - 0.5
    with np.errstate(divide="ignore", invalid="ignore"):
        steps = np.where(ahead > 0, (corner - position) / ahead, (-0.5 - position) / ahead)
    step = float(np.nanmin(np.where(np.abs(ahead) < 1e-6, np.inf, steps)))
    return np.asarray(position + max(step, 0.0) * ahead)


def components(graph: Graph) -> list[list[Line]]:
    """The lines of each connected part."""
    root: dict[int, int] = {key: key for key in graph.nodes}

    def find(key: int) -> int:
        while root[key] != key:
            root[key] = root[root[key]]
            key = root[key]
        return key

    for line in graph.lines:
        root[find(line.start)] = find(line.end)
    parts: dict[int, list[Line]] = {}
    for line in graph.lines:
        parts.setdefault(find(line.start), []).append(line)
    return list(parts.values())


def drop_crumbs(graph: Graph, least: float) -> None:
    """Forget connected parts shorter than `least` pixels in all, in place."""
    remaining = {
        id(line)
        for part in components(graph)
        if sum(x.length for x in part) >= least
        for line in part
    }
    graph.lines = [line for line in graph.lines if id(line) in remaining]
    graph.drop_lonely()
