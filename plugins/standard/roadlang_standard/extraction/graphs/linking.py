"""Bridge gaps: the cheapest way through the evidence from a dead end to a road or the rim."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra

from roadlang.geometry import Floats

from ..curves.smoothing import stations
from .dead_ends import TRUST_ALIGNED, DeadEnd, dead_ends, facing
from .graph import Graph, Line
from .graph_cleanup import join

Layer = NDArray[np.float32]
_RADIUS = 28
_SIDE = 2 * _RADIUS + 1
_CENTER = _RADIUS * _SIDE + _RADIUS
_OUTSIDE = np.iinfo(np.int32).max
"""Owner of the picture's rim: a road may leave there."""
_FLOOR = 0.05
_BACK = 9.0
"""Cost of a pixel on the surface of the ending road itself."""
_STRAIGHT = 0.9
"""Least cosine between a dead end's direction and the way to where it leaves the picture."""
_LEAVING = 0.8
"""Factor on the cost of a bridge to the rim."""


@dataclass(frozen=True)
class Bridge:
    """A way from a dead end to a line, or out of the picture, with its mean cost per pixel."""

    node: int
    goal: Line | None
    path: Floats
    cost: float


def link(graph: Graph, score: Layer, distance: float, worst: float, width: float) -> None:
    """Join dead ends to roads within `distance` pixels where a way costs at most `worst` a pixel.

    The cost of a pixel is -ln(score) + 0.05, but for the surface of the road itself, `width` pixels
    wide: no way leads back along it. Cheapest first; what a bridge hits is split. In place.
    """
    step = max(1.0, distance / _RADIUS)
    size = (max(1, round(score.shape[1] / step)), max(1, round(score.shape[0] / step)))
    coarse = cv2.resize(score, size, interpolation=cv2.INTER_AREA)
    price = np.pad(-np.log(np.clip(coarse, 1e-3, 1)) + _FLOOR, _RADIUS, constant_values=9.0)
    for _ in range(3):
        owner = _owners(graph, coarse.shape, step)
        ends = dead_ends(graph, score.shape)
        found = (
            _bridge(graph, end, faced, price, owner, step, worst, width)
            for end, faced in zip(ends, facing(ends, distance), strict=True)
        )
        bridges = [bridge for bridge in found if bridge is not None]
        if not bridges:
            return
        degree = graph.degree()
        for bridge in sorted(bridges, key=lambda item: item.cost):
            _build(graph, bridge, degree)
        join(graph)


def _owners(graph: Graph, shape: tuple[int, ...], step: float) -> NDArray[np.int32]:
    """Which line (index + 1) lies on each coarse pixel, or `_OUTSIDE`; padded as the prices are."""
    canvas = np.zeros(shape, np.float32)
    for index, line in enumerate(graph.lines):
        at = (line.points + 0.5) / step - 0.5
        cv2.polylines(
            canvas, [np.round(at * 16).astype(np.int32)], False, index + 1, 1, cv2.LINE_8, 4
        )
    owner = np.pad(canvas.astype(np.int32), _RADIUS)
    inner = owner[_RADIUS : _RADIUS + shape[0], _RADIUS : _RADIUS + shape[1]]
    for rim in (inner[0], inner[-1], inner[:, 0], inner[:, -1]):
        rim[rim == 0] = _OUTSIDE
    return owner


def _bridge(
    graph: Graph,
    end: DeadEnd,
    faced: list[tuple[Floats, float]],
    price: NDArray[np.float64],
    owner: NDArray[np.int32],
    step: float,
    worst: float,
    width: float,
) -> Bridge | None:
    line = graph.lines[end.line]
    x, y = _cell(end.place, step)
    window = (slice(y, y + _SIDE), slice(x, x + _SIDE))
    if price[window].shape != (_SIDE, _SIDE):
        return None
    there = owner[window].ravel().copy()
    own = _near_end(line, end.line, there, step)
    there[own] = 0
    if not there.any():
        return None
    costs = price[window] * _backwards(end.ahead)
    costs[_surface(own, width / step)] = _BACK
    far, before = dijkstra(
        _grid(costs),
        indices=_CENTER,
        limit=worst * _RADIUS / TRUST_ALIGNED,
        return_predecessors=True,
    )
    share = _shares(faced, (x, y), step)
    share[(there == _OUTSIDE) & _ahead(end.ahead).ravel()] = _LEAVING
    goals = np.flatnonzero((there > 0) & np.isfinite(far))
    if not len(goals):
        return None
    goal = int(goals[np.argmin((far * share)[goals])])
    cells = np.add(_path_cells(before, goal), (x - _RADIUS, y - _RADIUS))
    length = float(stations(cells.astype(float))[-1])
    cost = float(far[goal] * share[goal]) / max(length, 1e-9)
    if length < 1 or cost > worst:
        return None
    owned = int(there[goal])
    line_there = None if owned == _OUTSIDE else graph.lines[owned - 1]
    return Bridge(end.node, line_there, (cells + 0.5) * step - 0.5, cost)


def _cell(place: Floats, step: float) -> tuple[int, int]:
    x, y = np.round((place + 0.5) / step - 0.5).astype(int)
    return int(x), int(y)


def _path_cells(before: NDArray[np.int32], goal: int) -> NDArray[np.intp]:
    """Cells (x, y) of the window from its middle to the goal."""
    path = [goal]
    while path[-1] != _CENTER:
        path.append(int(before[path[-1]]))
    return np.array([(cell % _SIDE, cell // _SIDE) for cell in reversed(path)])


def _shares(
    faced: list[tuple[Floats, float]], at: tuple[int, int], step: float
) -> NDArray[np.float64]:
    """Which share of its cost a goal counts: less where a dead end comes the other way."""
    share = np.ones((_SIDE, _SIDE))
    for place, trust in faced:
        x, y = _cell(place, step)
        column, row = x - at[0] + _RADIUS, y - at[1] + _RADIUS
        share[max(0, row - 1) : max(0, row + 2), max(0, column - 1) : max(0, column + 2)] = trust
    return share.ravel()


def _ahead(ahead: Floats) -> NDArray[np.bool_]:
    """Which cells (side, side) of a window lie in the cone straight ahead of its middle."""
    x, y, away = _offsets()
    return np.asarray(x * ahead[0] + y * ahead[1] > _STRAIGHT * away)


def _near_end(line: Line, index: int, there: NDArray[np.int32], step: float) -> NDArray[np.bool_]:
    """The line's own pixels near its end: it may meet itself only after a long way round."""
    owned = there == index + 1
    return np.asarray(owned if line.length < 6 * _RADIUS * step else owned & _close(owned))


def _close(owned: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """The connected part of a window's own pixels that holds its middle."""
    grid = owned.reshape(_SIDE, _SIDE).astype(np.uint8)
    grid[_RADIUS - 1 : _RADIUS + 2, _RADIUS - 1 : _RADIUS + 2] = 1
    _, labels = cv2.connectedComponents(grid, connectivity=8)
    return np.asarray((labels == labels[_RADIUS, _RADIUS]).ravel())


def _surface(own: NDArray[np.bool_], width: float) -> NDArray[np.bool_]:
    """The cells (side, side) of a window that are the surface of a line of its own pixels, but for
    its end. `width` in cells."""
    line = own.reshape(_SIDE, _SIDE).astype(np.uint8)
    across = 2 * round(0.6 * width) + 1
    surface = cv2.dilate(line, cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (across, across)))
    return np.asarray((surface > 0) & (_offsets()[2] > 0.8 * width))


def _backwards(ahead: Floats) -> NDArray[np.float64]:
    """Factors (side, side) that make it expensive to leave in any direction but ahead."""
    x, y, away = _offsets()
    along = (x * ahead[0] + y * ahead[1]) / np.maximum(away, 1e-9)
    return np.where(away < 1.5, 1.0, 1.0 + 2.0 * np.clip(0.5 - along, 0, 1.5))


@lru_cache(maxsize=1)
def _offsets() -> tuple[NDArray[np.intp], NDArray[np.intp], Floats]:
    """Of the cells (side, side) of a window from its middle: right, down, and how far."""
    y, x = np.mgrid[-_RADIUS : _RADIUS + 1, -_RADIUS : _RADIUS + 1]
    return x, y, np.hypot(x, y)


@lru_cache(maxsize=1)
def _edges() -> tuple[NDArray[np.int32], NDArray[np.int32], NDArray[np.int32], Floats]:
    """Of a window's grid: from which cell each edge goes, in order, where those of each cell begin,
    to which cell it goes, and its length."""
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
    order = np.argsort(a, kind="stable")
    begins = np.append(0, np.cumsum(np.bincount(a))).astype(np.int32)
    return a[order], begins, b[order], length[order]


def _grid(costs: NDArray[np.float64]) -> csr_matrix:
    a, begins, b, length = _edges()
    flat = costs.ravel()
    data = (flat[a] + flat[b]) / 2 * length
    return csr_matrix((data, b, begins), shape=(flat.size, flat.size), copy=False)


def _build(graph: Graph, bridge: Bridge, degree: dict[int, int]) -> None:
    """Add the bridge if its end is still open and its goal still there; split the goal.

    The `degree` of the graph's nodes is kept up to date: to count anew would take long.
    """
    if degree.get(bridge.node) != 1:
        return
    if bridge.goal is None:
        node = graph.add_node(bridge.path[-1])
    elif any(line is bridge.goal for line in graph.lines):
        node = attach(graph, bridge.goal, bridge.path[-1])
    else:
        return
    if node == bridge.node:
        return
    path = bridge.path.copy()
    path[0], path[-1] = graph.nodes[bridge.node], graph.nodes[node]
    graph.lines.append(Line(bridge.node, node, path, linked=1.0))
    split = 0 if bridge.goal is None else 2
    degree[bridge.node] += 1
    degree[node] = degree.get(node, split) + 1


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
