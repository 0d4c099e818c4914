"""Bridge gaps: the cheapest way through the evidence from a dead end to another road."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra

from .chains import direction
from .clean import at_border, join
from .graph import Floats, Graph, Line
from .smoothing import stations

Layer = NDArray[np.float32]
_RADIUS = 28
_SIDE = 2 * _RADIUS + 1
_FLOOR = 0.05


@dataclass(frozen=True)
class Bridge:
    """A way from a dead end to a line, with its mean cost per pixel."""

    node: int
    goal: Line
    path: Floats
    cost: float


def link(graph: Graph, score: Layer, reach: float, worst: float) -> None:
    """Join dead ends to roads within `reach` pixels where a way costs at most `worst` a pixel.

    The cost of a pixel is -ln(score) + 0.05. Cheapest first; what a bridge hits is split. In place.
    """
    step = max(1.0, reach / _RADIUS)
    size = (max(1, round(score.shape[1] / step)), max(1, round(score.shape[0] / step)))
    coarse = cv2.resize(score, size, interpolation=cv2.INTER_AREA)
    price = np.pad(-np.log(np.clip(coarse, 1e-3, 1)) + _FLOOR, _RADIUS, constant_values=9.0)
    for _ in range(3):
        owner = _owners(graph, coarse.shape, step)
        bridges = [
            b
            for node in _dead_ends(graph, score.shape)
            if (b := _bridge(graph, node, price, owner, step, worst))
        ]
        if not bridges:
            return
        for bridge in sorted(bridges, key=lambda item: item.cost):
            _build(graph, bridge)
        join(graph)


def _dead_ends(graph: Graph, shape: tuple[int, ...]) -> list[int]:
    degree = graph.degree()
    return [
        node
        for node, count in degree.items()
        if count == 1 and not at_border(graph.nodes[node], (shape[0], shape[1]), 6.0)
    ]


def _owners(graph: Graph, shape: tuple[int, ...], step: float) -> NDArray[np.int32]:
    """Which line (index + 1) lies on each coarse pixel, padded as the prices are."""
    canvas = np.zeros(shape, np.float32)
    for index, line in enumerate(graph.lines):
        at = (line.points + 0.5) / step - 0.5
        cv2.polylines(
            canvas, [np.round(at * 16).astype(np.int32)], False, index + 1, 1, cv2.LINE_8, 4
        )
    return np.pad(canvas.astype(np.int32), _RADIUS)


def _bridge(
    graph: Graph,
    node: int,
    price: NDArray[np.float64],
    owner: NDArray[np.int32],
    step: float,
    worst: float,
) -> Bridge | None:
    index, side = next(
        (i, s)
        for i, line in enumerate(graph.lines)
        for s, n in ((0, line.start), (1, line.end))
        if n == node
    )
    line = graph.lines[index]
    x, y = np.round((graph.nodes[node] + 0.5) / step - 0.5).astype(int)
    window = (slice(y, y + _SIDE), slice(x, x + _SIDE))
    if price[window].shape != (_SIDE, _SIDE):
        return None
    ahead = -direction(line, side, 10.0 * step)
    costs = price[window] * _backwards(ahead)
    there = owner[window].ravel().copy()
    there[_near_own(line, side, index, there, step)] = 0
    centre = _RADIUS * _SIDE + _RADIUS
    far, before = dijkstra(
        _grid(costs), indices=centre, limit=worst * _RADIUS, return_predecessors=True
    )
    goals = np.flatnonzero((there > 0) & np.isfinite(far))
    if not len(goals):
        return None
    goal = int(goals[np.argmin(far[goals])])
    way = [goal]
    while way[-1] != centre:
        way.append(int(before[way[-1]]))
    cells = np.array(
        [(cell % _SIDE + x - _RADIUS, cell // _SIDE + y - _RADIUS) for cell in reversed(way)]
    )
    length = float(stations(cells.astype(float))[-1])
    if length < 1 or far[goal] / length > worst:
        return None
    return Bridge(
        node,
        graph.lines[int(there[goal]) - 1],
        (cells + 0.5) * step - 0.5,
        float(far[goal] / length),
    )


def _near_own(
    line: Line, side: int, index: int, there: NDArray[np.int32], step: float
) -> NDArray[np.bool_]:
    """The line's own pixels near its end: it may meet itself only after a long way round."""
    own = there == index + 1
    return own if line.length < 6 * _RADIUS * step else own & _close(own)


def _close(own: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """The connected part of a window's own pixels that holds its middle."""
    grid = own.reshape(_SIDE, _SIDE).astype(np.uint8)
    grid[_RADIUS - 1 : _RADIUS + 2, _RADIUS - 1 : _RADIUS + 2] = 1
    _, labels = cv2.connectedComponents(grid, connectivity=8)
    return np.asarray((labels == labels[_RADIUS, _RADIUS]).ravel())


def _backwards(ahead: Floats) -> NDArray[np.float64]:
    """Factors (side, side) that make it dear to leave other than ahead."""
    y, x = np.mgrid[-_RADIUS : _RADIUS + 1, -_RADIUS : _RADIUS + 1]
    along = (x * ahead[0] + y * ahead[1]) / np.maximum(np.hypot(x, y), 1e-9)
    return np.where(np.hypot(x, y) < 1.5, 1.0, 1.0 + 2.0 * np.clip(0.5 - along, 0, 1.5))


@lru_cache(maxsize=1)
def _edges() -> tuple[NDArray[np.int32], NDArray[np.int32], Floats]:
    cell = np.arange(_SIDE * _SIDE, dtype=np.int32).reshape(_SIDE, _SIDE)
    pairs = [
        (cell[:, :-1], cell[:, 1:], 1.0),
        (cell[:-1], cell[1:], 1.0),
        (cell[:-1, :-1], cell[1:, 1:], np.sqrt(2)),
        (cell[:-1, 1:], cell[1:, :-1], np.sqrt(2)),
    ]
    a = np.concatenate([p[0].ravel() for p in pairs] + [p[1].ravel() for p in pairs])
    b = np.concatenate([p[1].ravel() for p in pairs] + [p[0].ravel() for p in pairs])
    length = np.concatenate([np.full(p[0].size, p[2]) for p in pairs] * 2)
    return a, b, length


def _grid(costs: NDArray[np.float64]) -> csr_matrix:
    a, b, length = _edges()
    flat = costs.ravel()
    return csr_matrix(((flat[a] + flat[b]) / 2 * length, (a, b)), shape=(flat.size, flat.size))


def _build(graph: Graph, bridge: Bridge) -> None:
    """Add the bridge if its end is still open and its goal still there; split the goal."""
    if graph.degree().get(bridge.node) != 1 or not any(line is bridge.goal for line in graph.lines):
        return
    node = attach(graph, bridge.goal, bridge.path[-1])
    if node == bridge.node:
        return
    path = bridge.path.copy()
    path[0], path[-1] = graph.nodes[bridge.node], graph.nodes[node]
    graph.lines.append(Line(bridge.node, node, path, linked=1.0))


def attach(graph: Graph, line: Line, point: Floats, snap: float = 4.0) -> int:
    """The node of a line at a point: an end of it if near, else a new one that splits it."""
    index = int(np.argmin(np.hypot(*(line.points - point).T)))
    for node in (line.start, line.end):
        if np.hypot(*(graph.nodes[node] - line.points[index])) <= snap:
            return node
    if index in (0, len(line.points) - 1):
        return line.start if index == 0 else line.end
    node = graph.add_node(line.points[index])
    graph.lines = [other for other in graph.lines if other is not line]
    graph.lines.append(Line(line.start, node, line.points[: index + 1], line.linked))
    graph.lines.append(Line(node, line.end, line.points[index:], line.linked))
    return node
