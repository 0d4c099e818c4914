"""From a tidy graph to drawn roads: smooth center lines through junctions, widths, confidence."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Floats

from ..curves.edges import CenterLine, Sides, sides_of, typical_width, widths
from ..curves.even_points import even_points_of
from ..curves.fair_fitting import Fit
from ..curves.junction_points import Passing, extended, meeting_point
from ..curves.sampled import sampled
from ..curves.smoothing import resample, stations
from ..graphs.chains import chains
from ..graphs.graph import Graph, Line
from ..graphs.graph_cleanup import contract
from .chain_fitting import Run, fitted, through
from .found_network import FoundNetwork, FoundRoad

Layer = NDArray[np.float32]
_SAME = 1e-6
"""Junctions so near to each other, in pixels, are in one place."""
_STEP = 2.0
"""Pixels between the points of a road."""
_ROWS = 16384
"""So many places are looked at at a time: OpenCV takes no longer lists."""


@dataclass(frozen=True)
class Draft:
    """How lines are drawn, in pixels: the usual width sets all scales.

    `wavelength`: waves shorter than this many widths are noise; `tolerance`: how far the curve
    may leave what was seen, in widths, and `accuracy` the least of it, in pixels.
    """

    width: float
    wavelength: float = 3.0
    tolerance: float = 0.15
    accuracy: float = 0.5
    fixed_width: float | None = None
    fair: bool = True
    """whether lines and arcs are sought, or lines are only rid of waves"""
    level: float = 0.5
    """surface at the edge of a road"""
    sure: float = 0.0
    """surface on the center line from which on a width counts, where a tenth of the line has it"""
    blur: float = 0.0
    """pixels by which the surface is blurred: widths are taken to add to it in squares"""
    covered: NDArray[np.bool_] | None = None
    """where something covers the picture (h, w)"""
    twins: float = 0.0
    """junctions that a road joins are one if the roads that meet there meet within so many
    widths: where bent roads cross at a slant, thinning makes two of their crossing"""

    @property
    def waves(self) -> float:
        """Shortest wavelength kept, pixels."""
        return float(np.clip(self.wavelength * self.width, 8.0, 80.0))

    @property
    def fit(self) -> Fit:
        """How curves are fitted."""
        return Fit(
            self.width,
            self.level,
            max(self.accuracy, self.tolerance * self.width),
            0.5 * max(self.width, self.fixed_width or 0.0, 2.0),
            self.waves,
            self.fair,
            self.covered,
        )


def draft(graph: Graph, surface: Layer, score: Layer, options: Draft, method: str) -> FoundNetwork:
    """Draw every line; `surface` and `score` are (h, w) in 0..1: road surface, and evidence."""
    placed, curves = _drawn(graph, surface, options)
    contract(graph, _SAME, placed)
    order = sorted({node for line in graph.lines for node in (line.start, line.end)})
    index = {node: i for i, node in enumerate(order)}
    nodes = np.array([placed[node] for node in order]).reshape(-1, 2)
    drawn = [curves[id(line)] for line in graph.lines]
    lines = even_points_of(drawn, [_STEP] * len(drawn))
    centers = [CenterLine(points) for points in lines]
    edges = sides_of(centers, surface, 1.2 * options.width + 3, options.level)
    shown, sure = (_along(layer, lines) for layer in (surface, score))
    evidence = map(RoadEvidence, lines, edges, shown, sure)
    roads = tuple(
        _road(line, index, seen, options) for line, seen in zip(graph.lines, evidence, strict=True)
    )
    return FoundNetwork(nodes, roads, surface >= options.level, method)


def _drawn(
    graph: Graph, surface: Layer, options: Draft
) -> tuple[dict[int, Floats], dict[int, Floats]]:
    """Where the nodes are, and the curve of each line by its identity, from node to node."""
    degree = graph.degree()
    found = chains(graph, 1.5 * options.width + 4)
    ends = [(degree[chain.nodes[0]] == 1, degree[chain.nodes[-1]] == 1) for chain in found]
    runs = fitted(found, graph.nodes, ends, surface, options.fit)
    placed = _nodes(graph, runs, options)
    _join_twins(graph, placed, options.twins * options.width)
    curves: dict[int, Floats] = {}
    pieces = through(runs, placed, ends, surface, options.fit)
    for run, parts in zip(runs, pieces, strict=True):
        for (line, forward), piece in zip(run.chain.parts, parts, strict=True):
            curves[id(line)] = piece if forward else piece[::-1]
    return placed, curves


def _join_twins(graph: Graph, placed: dict[int, Floats], near: float) -> None:
    """Let two junctions that a road joins be in one place if they are `near`, pixels, in place."""
    degree = graph.degree()
    joined: set[int] = set()
    for line in graph.lines:
        a, b = line.start, line.end
        if line.closed or min(degree[a], degree[b]) < 3 or {a, b} & joined:
            continue
        if np.hypot(*(placed[b] - placed[a])) < near:
            joined |= {a, b}
            placed[a] = placed[b] = (placed[a] + placed[b]) / 2


def _nodes(graph: Graph, runs: list[Run], options: Draft) -> dict[int, Floats]:
    """Where the fitted curves meet; a dead end is where its curve ends."""
    passing: dict[int, list[Passing]] = {}
    near = 2.5 * options.width + 10
    placed: dict[int, Floats] = {}
    degree = graph.degree()
    for run in runs:
        for place, node in enumerate(run.nodes):
            ends = run.is_end(place)
            if degree[node] == (2 if run.chain.closed else 1):
                placed[node] = run.curve[0 if place == 0 else -1]
                continue
            part = _part(run, place, near)
            passing.setdefault(node, []).append(Passing(part, not ends))
    limit = 1.5 * options.width + 3
    for node, curves in passing.items():
        placed[node] = meeting_point(graph.nodes[node], curves, limit)
    return placed


def _part(run: Run, place: int, near: float) -> Floats:
    """The run's curve about one of its nodes, carried straight on where it ends there."""
    along, reached = stations(run.curve), run.reached[place]
    if run.chain.closed:
        around = np.vstack([run.curve[:-1]] * 3)
        middle = reached + along[-1]
        s = np.arange(len(around)) * along[-1] / (len(run.curve) - 1)
        return np.asarray(around[np.abs(s - middle) <= near])
    part = run.curve[np.abs(along - reached) <= near]
    if not run.is_end(place):
        return part
    return extended(part, (near, 0.0) if place == 0 else (0.0, near))


@dataclass(frozen=True)
class RoadEvidence:
    """What is seen along a road: its points (n, 2), its edges beside them, and surface and score at
    them (n,)."""

    points: Floats
    edges: Sides
    surface: Layer
    score: Layer


def _road(line: Line, index: dict[int, int], seen: RoadEvidence, options: Draft) -> FoundRoad:
    points, edges = seen.points, seen.edges
    solid = seen.surface >= options.sure
    if solid.mean() > 0.1:
        edges = edges.where(solid)
    closed = line.closed
    if options.fixed_width is not None:
        wide, spread = np.full(len(points), options.fixed_width), 0.0
    else:
        wide, spread = widths(edges, options.width, 4 * options.waves / 2, closed)
        wide = np.sqrt(np.maximum(wide**2 - options.blur**2, (0.4 * wide) ** 2))
    sure = np.clip(seen.score, 0, 1).astype(float) * (1 - 0.5 * line.linked)
    ends = index[line.start], index[line.end]
    return FoundRoad(*ends, points, wide, spread, round(float(sure.mean()), 4), line.linked, sure)


def _along(layer: Layer, lines: Sequence[Floats]) -> list[Layer]:
    """The layer (h, w) at the points (n, 2) of each of the lines, (n,)."""
    if not lines:
        return []
    x, y = np.concatenate(lines).astype(np.float32).T
    places = [np.ascontiguousarray(axis)[:, None] for axis in (x, y)]
    found = [
        sampled(layer, *(axis[first : first + _ROWS] for axis in places))[:, 0]
        for first in range(0, len(x), _ROWS)
    ]
    return np.split(np.concatenate(found), np.cumsum([len(line) for line in lines])[:-1])


def typical_width_of(graph: Graph, mask: NDArray[np.bool_]) -> float:
    """Twice the median distance from the lines to the edge of the mask, weighted by length."""
    return width_within(graph, cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, 5))


def width_within(graph: Graph, inner: Layer) -> float:
    """As `typical_width_of`, where it is known how far `inner` (h, w) pixels are from the edge."""
    samples = [resample(line.points, 2.0).round().astype(int) for line in graph.lines]
    if not samples:
        return 1.0
    x, y = np.vstack(samples).T
    inside = (x >= 0) & (y >= 0) & (x < inner.shape[1]) & (y < inner.shape[0])
    radii = inner[y[inside], x[inside]]
    radii = np.minimum(radii[radii > 0], min(inner.shape) / 2)
    return float(max(1.0, 2 * np.median(radii) - 1)) if len(radii) else 1.0


__all__ = ["Draft", "draft", "typical_width", "typical_width_of", "width_within"]
