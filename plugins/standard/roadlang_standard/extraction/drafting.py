"""From a tidy graph to drawn roads: smooth center lines through junctions, widths, confidence."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Floats

from .chains import LineChain, chains
from .edges import recentered, sides, usual_width, widths
from .found import FoundNetwork, FoundRoad
from .graph import Graph, Line
from .smoothing import resample, smooth, stations

Layer = NDArray[np.float32]


@dataclass(frozen=True)
class Draft:
    """How lines are drawn, in pixels: the usual width sets all scales.

    `wavelength`: waves shorter than this many widths are noise; `tolerance`: how far the curve
    may leave what was seen, in widths.
    """

    width: float
    wavelength: float = 3.0
    tolerance: float = 0.15
    fixed_width: float | None = None
    recenter: bool = True
    level: float = 0.5
    """surface at the edge of a road"""
    sure: float = 0.0
    """surface on the center line from which on a width counts, where a tenth of the line has it"""
    blur: float = 0.0
    """pixels by which the surface is blurred: widths are taken to add to it in squares"""

    @property
    def waves(self) -> float:
        """Shortest wavelength kept, pixels."""
        return float(np.clip(self.wavelength * self.width, 8.0, 80.0))


def draft(graph: Graph, surface: Layer, score: Layer, options: Draft, method: str) -> FoundNetwork:
    """Draw every line; `surface` and `score` are (h, w) in 0..1: road surface, and evidence."""
    placed: dict[int, Floats] = {}
    curves: dict[int, Floats] = {}
    for chain in chains(graph, 1.5 * options.width + 4):
        _draw(chain, graph, surface, options, placed, curves)
    order = sorted({node for line in graph.lines for node in (line.start, line.end)})
    index = {node: i for i, node in enumerate(order)}
    nodes = np.array([placed[node] for node in order]).reshape(-1, 2)
    roads = tuple(
        _road(line, curves[id(line)], index, surface, score, options) for line in graph.lines
    )
    return FoundNetwork(nodes, roads, surface >= options.level, method)


def _draw(
    chain: LineChain,
    graph: Graph,
    surface: Layer,
    options: Draft,
    placed: dict[int, Floats],
    curves: dict[int, Floats],
) -> None:
    nodes = chain.nodes
    loop = len(chain.parts) == 1 and chain.parts[0][0].closed
    free_loop = loop and graph.degree()[nodes[0]] == 2
    points = _concatenated(chain)
    for end, node in ((0, nodes[0]), (-1, nodes[-1])):
        points[end] = placed.get(node, points[end])
    if free_loop:
        curve = _closed_curve(points, surface, options)
    else:
        through = [graph.nodes[node] for node in nodes[1:-1]]
        degree = graph.degree()
        free = (degree[nodes[0]] == 1, degree[nodes[-1]] == 1)
        curve = _open_curve(points, through, free, surface, options)
    placed.setdefault(nodes[0], curve[0])
    placed.setdefault(nodes[-1], curve[-1])
    _split(chain, nodes, graph, curve, placed, curves)


def _concatenated(chain: LineChain) -> Floats:
    pieces = [line.points if forward else line.points[::-1] for line, forward in chain.parts]
    return resample(np.vstack([pieces[0], *[piece[1:] for piece in pieces[1:]]]))


def _open_curve(
    points: Floats,
    through: list[Floats],
    free: tuple[bool, bool],
    surface: Layer,
    options: Draft,
) -> Floats:
    weights = np.ones(len(points))
    for place in [points[0], points[-1], *through]:
        near = np.hypot(*(points - place).T) < 0.6 * options.width
        if near.sum() < 0.5 * len(points):
            weights[near] = 0.02
    tolerance, tightest = max(0.8, options.tolerance * options.width), 0.5 * options.width
    curve = smooth(points, options.waves, tolerance, tightest, weights, free=free)
    if options.recenter and len(points) > options.width:
        curve = resample(curve)
        seen = sides(curve, surface, 1.1 * options.width + 3, options.level)
        held = (not free[0], not free[1])
        curve = recentered(curve, seen, 0.8 * options.waves, False, held)
        curve = smooth(resample(curve), 0.6 * options.waves, tolerance, tightest, free=free)
    return curve


def _closed_curve(points: Floats, surface: Layer, options: Draft) -> Floats:
    tolerance, tightest = max(0.8, options.tolerance * options.width), 0.5 * options.width
    curve = smooth(points[:-1], options.waves, tolerance, tightest, closed=True)
    if options.recenter:
        curve = resample(np.vstack([curve, curve[:1]]))[:-1]
        seen = sides(np.vstack([curve, curve[:1]]), surface, 1.1 * options.width + 3, options.level)
        ring = np.vstack([curve, curve[:1]])
        ring = recentered(ring, seen, 0.8 * options.waves, False, held=(False, False))
        curve = smooth(resample(ring)[:-1], 0.6 * options.waves, tolerance, tightest, closed=True)
    return np.vstack([curve, curve[:1]])


def _split(
    chain: LineChain,
    nodes: list[int],
    graph: Graph,
    curve: Floats,
    placed: dict[int, Floats],
    curves: dict[int, Floats],
) -> None:
    lengths = np.cumsum([line.length for line, _ in chain.parts])
    station = stations(curve)
    cuts = [0]
    for node, reached in zip(nodes[1:-1], lengths, strict=False):
        goal = placed.get(node, graph.nodes[node])
        expected = np.abs(station / station[-1] - reached / lengths[-1]) * station[-1]
        away = np.hypot(*(curve - goal).T) + 0.05 * expected
        cut = int(
            np.clip(np.argmin(away), cuts[-1] + 1, len(curve) - 1 - (len(chain.parts) - len(cuts)))
        )
        placed.setdefault(node, curve[cut])
        cuts.append(cut)
    cuts.append(len(curve) - 1)
    for (line, forward), a, b in zip(chain.parts, cuts[:-1], cuts[1:], strict=True):
        piece = curve[a : b + 1].copy()
        piece = piece if forward else piece[::-1]
        curves[id(line)] = _attached(piece, placed[line.start], placed[line.end])


def _attached(piece: Floats, start: Floats, end: Floats, blend: float = 12.0) -> Floats:
    """The piece bent a little so that it begins and ends exactly at its nodes."""
    station = stations(piece)
    blend_length = min(blend, station[-1] / 2) or 1.0
    fade_in = np.clip(1 - station / blend_length, 0, 1)[:, None]
    fade_out = np.clip(1 - (station[-1] - station) / blend_length, 0, 1)[:, None]
    moved = piece + fade_in * (start - piece[0]) + fade_out * (end - piece[-1])
    moved[0], moved[-1] = start, end
    return np.asarray(moved)


def _road(
    line: Line, curve: Floats, index: dict[int, int], surface: Layer, score: Layer, options: Draft
) -> FoundRoad:
    points = resample(curve, 2.0)
    at = points.astype(np.float32).reshape(1, -1, 2)
    seen = sides(points, surface, 1.2 * options.width + 3, options.level)
    solid = _along(surface, at) >= options.sure
    if solid.mean() > 0.1:
        seen = seen.where(solid)
    closed = line.closed
    if options.fixed_width is not None:
        wide, spread = np.full(len(points), options.fixed_width), 0.0
    else:
        wide, spread = widths(seen, options.width, 4 * options.waves / 2, closed)
        wide = np.sqrt(np.maximum(wide**2 - options.blur**2, (0.4 * wide) ** 2))
    confidence = float(np.clip(_along(score, at).mean(), 0, 1)) * (1 - 0.5 * line.linked)
    return FoundRoad(
        index[line.start], index[line.end], points, wide, spread, round(confidence, 4), line.linked
    )


def _along(layer: Layer, at: Layer) -> Layer:
    """The layer (h, w) at points (1, n, 2), (n,)."""
    found = cv2.remap(
        layer, at[..., 0], at[..., 1], cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE
    )
    return np.asarray(found[0], np.float32)


def usual_width_of(graph: Graph, mask: NDArray[np.bool_]) -> float:
    """Twice the median distance from the lines to the edge of the mask, weighted by length."""
    inner = cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, 5)
    samples = [resample(line.points, 2.0).round().astype(int) for line in graph.lines]
    if not samples:
        return 1.0
    x, y = np.vstack(samples).T
    inside = (x >= 0) & (y >= 0) & (x < mask.shape[1]) & (y < mask.shape[0])
    radii = inner[y[inside], x[inside]]
    radii = np.minimum(radii[radii > 0], max(mask.shape) / 2)
    return float(max(1.0, 2 * np.median(radii) - 1)) if len(radii) else 1.0


__all__ = ["Draft", "draft", "usual_width", "usual_width_of"]
