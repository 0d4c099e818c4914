"""A skeleton as a graph: junctions and ends are nodes, the lines between them are edges."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from roadlang.geometry import Booleans, Floats

from .graph import Graph, Line

Indices = NDArray[np.intp]


@dataclass(frozen=True)
class _Thinned:
    """The pixels (n,) of a skeleton, in order, as indices of a picture with an empty rim whose rows
    are `stride` long; and which of their neighbors belong to it as well (8, n), clockwise."""

    pixels: Indices
    ring: Booleans
    around: Indices
    stride: int

    @staticmethod
    def of(skeleton: Booleans) -> _Thinned:
        padded = np.pad(skeleton, 1)
        stride, flat = padded.shape[1], padded.ravel()
        pixels = np.flatnonzero(flat)
        around = np.array(
            [-stride, -stride + 1, 1, stride + 1, stride, stride - 1, -1, -stride - 1]
        )
        return _Thinned(pixels, flat.take(pixels + around[:, None]), around, stride)

    def junctions(self) -> Indices:
        """Pixels where at least three branches meet (crossing number), and knots of them."""
        rises = (~self.ring & np.roll(self.ring, -1, axis=0)).sum(axis=0)
        chosen: Indices = self.pixels[(rises >= 3) | (self.ring.sum(axis=0) >= 4)]
        return chosen

    def onward(self, beside: set[int]) -> dict[int, int]:
        """For pixels with two neighbors that are not `beside` nodes, the sum of both: less the one,
        it is the other."""
        plain = self.ring.sum(axis=0) == 2
        sums = 2 * self.pixels[plain] + self.around @ self.ring[:, plain]
        found = dict(zip(self.pixels[plain].tolist(), sums.tolist(), strict=True))
        for pixel in beside & found.keys():
            del found[pixel]
        return found

    def place(self, pixels: Indices | int) -> Floats:
        """Points (..., 2) in the picture without the rim."""
        found = np.empty((*np.shape(pixels), 2))
        found[..., 1], found[..., 0] = np.divmod(pixels, self.stride)
        found -= 1.0
        return found


def trace(skeleton: Booleans) -> Graph:
    """The graph of a one-pixel skeleton (h, w)."""
    thin = _Thinned.of(skeleton)
    graph = Graph()
    junctions = thin.junctions()
    labels = _labels(junctions, thin)
    places, counts = thin.place(junctions) + 1.0, np.bincount(labels)
    centers = [np.bincount(labels, column) for column in places.T] / np.maximum(counts, 1)
    for key in range(1, len(counts)):
        graph.nodes[key] = centers[:, key] - 1.0
    _walk(graph, thin, dict(zip(junctions.tolist(), labels.tolist(), strict=True)))
    return graph


def _labels(pixels: Indices, thin: _Thinned) -> NDArray[np.intp]:
    """The connected part, from 1 on, of each of some pixels (n,), in ascending order. Parts are
    numbered by the squares of 2 x 2 pixels, row by row, in which they begin."""
    if not len(pixels):
        return np.zeros(0, np.intp)
    links = []
    for step in thin.around[2:6]:
        to = np.minimum(np.searchsorted(pixels, pixels + step), len(pixels) - 1)
        found = np.flatnonzero(pixels[to] == pixels + step)
        links.append(np.array([found, to[found]]))
    starts, ends = np.concatenate(links, axis=1)
    linked = coo_array((np.ones(len(starts), bool), (starts, ends)), shape=2 * (len(pixels),))
    count, part = connected_components(linked, directed=False)
    rows, columns = np.divmod(pixels, thin.stride)
    squares = np.full(count, np.iinfo(np.intp).max)
    np.minimum.at(squares, part, rows // 2 * thin.stride + columns // 2)
    number = np.empty(count, np.intp)
    number[np.argsort(squares)] = np.arange(1, count + 1)
    return np.asarray(number[part])


def _walk(graph: Graph, thin: _Thinned, owner: dict[int, int]) -> None:
    stride = thin.stride
    steps = (-1, 1, -stride, stride, -stride - 1, -stride + 1, stride - 1, stride + 1)
    free = set(thin.pixels.tolist()) - owner.keys()
    beside = {pixel + s for pixel in owner for s in steps}
    onward = thin.onward(beside)

    def go(pixel: int, start: int, path: list[int]) -> None:
        """Follow free pixels until a node or a dead end."""
        while True:
            path.append(pixel)
            free.discard(pixel)
            if pixel not in beside and len(path) > 2:  # most pixels: no need to look for nodes
                pixel = _run(path, onward, free, steps)
                if pixel not in free:
                    return _add(graph, start, None, path, thin)
                continue
            nodes = [owner[pixel + s] for s in steps if pixel + s in owner]
            hit = next((node for node in nodes if _fresh(path, start, node)), None)
            if hit is not None:
                return _add(graph, start, hit, path, thin)
            following = _following(pixel, start if len(path) < 3 else None, free, owner, steps)
            if following is None:
                back = len(path) > 2 and start in nodes
                return _add(graph, start, start if back else None, path, thin)
            pixel = following

    for root in list(owner):
        for s in steps:
            if root + s in free:
                go(root + s, owner[root], [])
    for end in _tips(free, thin):
        if end in free:
            go(end, graph.add_node(thin.place(end)), [])
    while free:
        root = min(free)
        free.discard(root)
        following = _first(root, free, steps)
        node = graph.add_node(thin.place(root))
        if following in free:
            owner[root] = node
            for s in steps:
                beside.add(root + s)
                onward.pop(root + s, None)
            go(following, node, [])


def _tips(free: set[int], thin: _Thinned) -> list[int]:
    """Pixels with at most one neighbor, in order."""
    if not free:
        return []
    pixels = np.array(sorted(free))
    is_free = np.zeros(pixels[-1] + thin.stride + 2, np.uint8)
    is_free[pixels] = 1
    neighbors = is_free.take(pixels + thin.around[:, None]).sum(axis=0)
    return [int(pixel) for pixel in pixels[neighbors <= 1]]


def _run(path: list[int], onward: dict[int, int], free: set[int], steps: tuple[int, ...]) -> int:
    """Carry a path on along pixels from which there is one way on; returns the pixel after them, -1
    if there is none."""
    begun, (before, pixel) = len(path), path[-2:]
    while (both := onward.get(pixel)) is not None:
        before, pixel = pixel, both - before
        if pixel not in free or pixel not in onward:
            break
        path.append(pixel)
    free.difference_update(path[begun:])
    return pixel if pixel in free else _first(path[-1], free, steps)


def _first(pixel: int, free: set[int], steps: tuple[int, ...]) -> int:
    """The first neighbor that is free, -1 if none is."""
    return next((pixel + s for s in steps if pixel + s in free), -1)


def _following(
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


def _add(graph: Graph, start: int, end: int | None, path: list[int], thin: _Thinned) -> None:
    points = thin.place(np.array(path))
    if end is None:
        end = graph.add_node(points[-1])
    polyline = np.vstack([graph.nodes[start], points, graph.nodes[end]])
    step = polyline[1:] - polyline[:-1]
    apart = np.append(True, np.hypot(step[:, 0], step[:, 1]) > 1e-9)
    if apart.sum() > 1:
        graph.lines.append(Line(start, end, polyline[apart]))
