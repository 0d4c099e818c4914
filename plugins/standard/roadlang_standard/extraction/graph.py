"""A skeleton as a graph: junctions and ends are nodes, the lines between them are edges."""

from __future__ import annotations

from dataclasses import dataclass, field

import cv2
import numpy as np

from roadlang.geometry import Booleans, Floats


@dataclass
class Line:
    """A line between two nodes: points (n, 2) in pixels, x right, y down; a loop has one node."""

    start: int
    end: int
    points: Floats
    linked: float = 0.0
    """Share of the length that was bridged without evidence."""

    @property
    def length(self) -> float:
        """Pixels."""
        steps = self.points[1:] - self.points[:-1]
        return float(np.hypot(steps[:, 0], steps[:, 1]).sum())

    @property
    def closed(self) -> bool:
        """Whether it comes back to where it began."""
        return self.start == self.end


@dataclass
class Graph:
    """Nodes (x, y) by id, in the order of their ids, and lines."""

    nodes: dict[int, Floats] = field(default_factory=dict)
    lines: list[Line] = field(default_factory=list)

    def degree(self) -> dict[int, int]:
        """How many line ends meet at each node."""
        count = dict.fromkeys(self.nodes, 0)
        for line in self.lines:
            count[line.start] += 1
            count[line.end] += 1
        return count

    def add_node(self, position: Floats) -> int:
        """A new node; its id."""
        key = next(reversed(self.nodes), -1) + 1
        self.nodes[key] = np.asarray(position, float)
        return key

    def drop_lonely(self) -> None:
        """Forget nodes without lines."""
        self.nodes = {key: self.nodes[key] for key, count in self.degree().items() if count}


def trace(skeleton: Booleans) -> Graph:
    """The graph of a one-pixel skeleton."""
    stride = skeleton.shape[1] + 2
    padded = np.pad(skeleton, 1)
    junctions = _junctions(padded)
    graph, owner = Graph(), {}
    count, labels, _, centers = cv2.connectedComponentsWithStats(
        junctions.astype(np.uint8), connectivity=8
    )
    for key in range(1, count):
        graph.nodes[key] = centers[key] - 1.0
    for flat in np.flatnonzero(junctions):
        owner[int(flat)] = int(labels.flat[flat])
    _walk(graph, padded, owner, stride)
    return graph


def _junctions(padded: Booleans) -> Booleans:
    """Pixels where at least three branches meet (crossing number), and knots of them."""
    stride = padded.shape[1]
    flat = padded.ravel()
    pixels = np.flatnonzero(flat)
    around = (-stride, -stride + 1, 1, stride + 1, stride, stride - 1, -1, -stride - 1)
    ring = np.array([flat[pixels + step] for step in around])
    rises = (~ring & np.roll(ring, -1, axis=0)).sum(axis=0)
    found = np.zeros_like(padded)
    found.flat[pixels[(rises >= 3) | (ring.sum(axis=0) >= 4)]] = True
    return found


def _walk(graph: Graph, padded: Booleans, owner: dict[int, int], stride: int) -> None:
    steps = (-1, 1, -stride, stride, -stride - 1, -stride + 1, stride - 1, stride + 1)
    free = set(np.flatnonzero(padded).tolist()) - owner.keys()
    beside = {pixel + s for pixel in owner for s in steps}

    def go(pixel: int, start: int, path: list[int]) -> None:
        """Follow free pixels until a node or a dead end."""
        while True:
            path.append(pixel)
            free.discard(pixel)
            if pixel not in beside and len(path) > 2:  # most pixels: no need to look for nodes
                for s in steps:
                    if pixel + s in free:
                        pixel += s
                        break
                else:
                    return _add(graph, start, None, path, stride)
                continue
            nodes = [owner[pixel + s] for s in steps if pixel + s in owner]
            hit = next((node for node in nodes if _fresh(path, start, node)), None)
            if hit is not None:
                return _add(graph, start, hit, path, stride)
            onward = _onward(pixel, start if len(path) < 3 else None, free, owner, steps)
            if onward is None:
                back = len(path) > 2 and start in nodes
                return _add(graph, start, start if back else None, path, stride)
            pixel = onward

    for root in list(owner):
        for s in steps:
            if root + s in free:
                go(root + s, owner[root], [])
    for end in _tips(free, padded.size, steps):
        if end in free:
            go(end, graph.add_node(_xy(end, stride)), [])
    while free:
        root = min(free)
        free.discard(root)
        onward = next((root + s for s in steps if root + s in free), None)
        node = graph.add_node(_xy(root, stride))
        if onward is not None:
            owner[root] = node
            beside.update(root + s for s in steps)
            go(onward, node, [])


def _tips(free: set[int], size: int, steps: tuple[int, ...]) -> list[int]:
    """Pixels with at most one neighbor."""
    pixels = np.array(sorted(free), int)
    is_free = np.zeros(size, np.uint8)
    is_free[pixels] = 1
    around = sum(is_free[pixels + step] for step in steps)
    return [int(pixel) for pixel in pixels[np.asarray(around) <= 1]]


def _onward(
    pixel: int, start: int | None, free: set[int], owner: dict[int, int], steps: tuple[int, ...]
) -> int | None:
    """The next free pixel: straight steps before diagonal ones.

    First of all a step away from the `start`, if that is near, or the beginning of its next branch
    would be taken for the way.
    """
    ahead = [pixel + s for s in steps if pixel + s in free]
    if start is not None and len(ahead) > 1:
        away = [p for p in ahead if all(owner.get(p + s) != start for s in steps)]
        ahead = away or ahead
    return ahead[0] if ahead else None


def _fresh(path: list[int], start: int, node: int) -> bool:
    """A line may come back to its own node only after having left it."""
    return node != start or len(path) > 4


def _add(graph: Graph, start: int, end: int | None, path: list[int], stride: int) -> None:
    flat = np.array(path)
    points = np.column_stack([flat % stride - 1.0, flat // stride - 1.0])
    if end is None:
        end = graph.add_node(points[-1])
    polyline = np.vstack([graph.nodes[start], points, graph.nodes[end]])
    keep = np.r_[True, np.hypot(*np.diff(polyline, axis=0).T) > 1e-9]
    if keep.sum() > 1:
        graph.lines.append(Line(start, end, polyline[keep]))


def _xy(flat: int, stride: int) -> Floats:
    return np.array([flat % stride - 1.0, flat // stride - 1.0])
