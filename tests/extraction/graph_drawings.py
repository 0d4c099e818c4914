"""Graphs and evidence drawn by hand, for tests of extraction."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from roadlang_standard.extraction.graphs.graph import Graph, Line

Point = tuple[float, float]


def dense(*corners: Point) -> np.ndarray:
    """Points a pixel apart along a polyline, its corners among them."""
    pieces = [np.array([corners[0]], float)]
    for (x0, y0), (x1, y1) in pairwise(corners):
        count = max(1, round(float(np.hypot(x1 - x0, y1 - y0))))
        share = np.arange(1, count + 1)[:, None] / count
        pieces.append(np.array([x0, y0]) + share * np.array([x1 - x0, y1 - y0]))
    return np.vstack(pieces)


def graph_of(*polylines: tuple[Point, ...]) -> Graph:
    """Lines through these points; ends at one place are one node, numbered as they come."""
    graph, at = Graph(), dict[Point, int]()
    for corners in polylines:
        for end in (corners[0], corners[-1]):
            if end not in at:
                at[end] = graph.add_node(np.array(end, float))
        graph.lines.append(Line(at[corners[0]], at[corners[-1]], dense(*corners)))
    return graph


def lengths(graph: Graph) -> list[float]:
    return sorted(round(line.length, 1) for line in graph.lines)


def surface(height: int, width: int, *bands: tuple[slice, slice]) -> np.ndarray:
    """Zero, and one in the bands (rows, columns)."""
    layer = np.zeros((height, width), np.float32)
    for band in bands:
        layer[band] = 1.0
    return layer


def picture(text: str) -> np.ndarray:
    """True where a text has `#`."""
    return np.array([[c == "#" for c in row.strip()] for row in text.strip().splitlines()])
