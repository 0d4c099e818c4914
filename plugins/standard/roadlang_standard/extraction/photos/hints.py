"""A user's strokes, written into the evidence: points on roads, boxes without roads."""

from __future__ import annotations

from itertools import pairwise

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra

from roadlang.geometry import Floats

from ..curves.smoothing import resample, smooth

Layer = NDArray[np.float32]
_MOST_CELLS = 120_000
_SURE = 1.0


def leave_out(layers: list[Layer], boxes: tuple[tuple[tuple[float, float], ...], ...]) -> None:
    """Clear boxes, each given by two or more corners (x, y) in pixels, in place."""
    for box in boxes:
        (left, top), (right, bottom) = np.min(box, axis=0), np.max(box, axis=0)
        rows = slice(max(0, int(np.floor(top))), max(0, int(np.ceil(bottom)) + 1))
        columns = slice(max(0, int(np.floor(left))), max(0, int(np.ceil(right)) + 1))
        for layer in layers:
            layer[rows, columns] = 0


def paths_through(score: Layer, points: Floats) -> list[Floats]:
    """The cheapest ways (n, 2) over the evidence from each of the points (k, 2) to the next.

    They follow roads where they are seen and go straight where they are not; pixels throughout.
    """
    height, width = score.shape
    step = max(1.0, float(np.sqrt(height * width / _MOST_CELLS)))
    size = (max(2, round(width / step)), max(2, round(height / step)))
    coarse = cv2.resize(score, size, interpolation=cv2.INTER_AREA)
    scale = np.array([width / size[0], height / size[1]])
    cells = np.clip(np.round((points + 0.5) / scale - 0.5).astype(int), 0, np.array(size) - 1)
    graph = _grid(-np.log(np.clip(coarse, 0.02, 1)) + 0.08)
    paths = []
    for (start, goal), ends in zip(pairwise(cells), pairwise(points), strict=True):
        path = (np.array(_shortest(graph, start, goal, size[0]), float) + 0.5) * scale - 0.5
        line = resample(np.vstack([ends[0], path[1:-1], ends[1]]))
        paths.append(smooth(line, 8 * step, 2 * step) if len(line) > 8 else line)
    return paths


def _grid(price: NDArray[np.float64]) -> csr_matrix:
    rows, columns = price.shape
    cell = np.arange(rows * columns, dtype=np.int32).reshape(rows, columns)
    pairs = [
        (cell[:, :-1], cell[:, 1:], 1.0),
        (cell[:-1], cell[1:], 1.0),
        (cell[:-1, :-1], cell[1:, 1:], 2**0.5),
        (cell[:-1, 1:], cell[1:, :-1], 2**0.5),
    ]
    a = np.concatenate([p[0].ravel() for p in pairs])
    b = np.concatenate([p[1].ravel() for p in pairs])
    length = np.concatenate([np.full(p[0].size, p[2]) for p in pairs])
    flat = price.ravel()
    return csr_matrix(((flat[a] + flat[b]) / 2 * length, (a, b)), shape=(flat.size, flat.size))


def _shortest(
    graph: csr_matrix, start: NDArray[np.intp], goal: NDArray[np.intp], columns: int
) -> list[tuple[int, int]]:
    source, target = int(start[1] * columns + start[0]), int(goal[1] * columns + goal[0])
    _, before = dijkstra(graph, directed=False, indices=source, return_predecessors=True)
    path = [target]
    while path[-1] != source:
        path.append(int(before[path[-1]]))
    return [(cell % columns, cell // columns) for cell in reversed(path)]


def paint(surface: Layer, score: Layer, path: Floats, width: float) -> None:
    """Make a way certain in both maps, as wide as a road, in place."""
    stroke = np.zeros(surface.shape, np.uint8)
    fixed = [np.round(path * 16).astype(np.int32)]
    cv2.polylines(stroke, fixed, False, 255, max(2, round(width)), cv2.LINE_AA, 4)
    cover = stroke.astype(np.float32) / 255 * _SURE
    np.maximum(surface, cover, out=surface)
    np.maximum(score, cover, out=score)
