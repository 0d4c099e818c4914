"""Roads of a mask: skeleton, graph, tidy, draw."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from .dead_end_stubs import drop_corners, lengthen_square_ends, stubs
from .drafting import Draft, draft, typical_width_of
from .found_network import FoundNetwork
from .graph import trace
from .graph_cleanup import contract, drop_crumbs, extend_to_border, join, prune
from .oblique import join_oblique_crossings
from .skeleton import skeleton
from .square_stubs import add_square_stubs

Layer = NDArray[np.float32]


def roads_of_surface(
    surface: Layer,
    method: str,
    spline: bool = True,
    width: float | None = None,
    least: float | None = None,
    specks: float = 12.0,
    waves: float = 2.0,
    tolerance: float = 0.0,
) -> FoundNetwork:
    """The road network of a clean surface (h, w), 0..1, whose half level is the road edge.

    Dead ends shorter than `least` pixels (by default the usual width) go; so do parts and holes
    of fewer than `specks` square pixels.
    """
    mask = without_specks(surface >= 0.5, specks)
    thin = skeleton(mask)
    while _is_noise(thin) and specks < 1e4:
        specks *= 4
        surface = cv2.GaussianBlur(surface, (0, 0), 2.0)
        mask = without_specks(surface >= 0.5, specks)
        thin = skeleton(mask)
    graph = trace(thin)
    typical = typical_width_of(graph, mask)
    inner = cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, 5)
    drop_corners(graph, inner, typical)
    short = []
    if least is None:
        short = [*add_square_stubs(graph, mask, typical), *stubs(graph, inner, typical)]
    contract(graph, 1.2 * typical)
    shortest = 1.1 * typical if least is None else least
    prune(graph, shortest, mask.shape, margin=0.6 * typical + 2, sure=short)
    join(graph)
    join_oblique_crossings(graph, typical)
    drop_crumbs(graph, min(2 * typical, 0.5 * max(mask.shape)))
    typical = typical_width_of(graph, mask)
    lengthen_square_ends(graph, mask, typical)
    extend_to_border(graph, (mask.shape[0], mask.shape[1]), 0.7 * typical + 2)
    settings = Draft(
        typical, waves if spline else 0.5, tolerance, _accuracy(surface), width, fair=spline
    )
    score = cv2.GaussianBlur(mask.astype(np.float32), (0, 0), 0.8)
    return draft(graph, surface, score, settings, method)


def _is_noise(thin: Booleans) -> bool:
    """Whether a skeleton fills a large picture more than roads do: it is smoothed first."""
    return bool(thin.size > 100_000 and thin.mean() > 0.03)


def _accuracy(surface: Layer) -> float:
    """How far in pixels a curve may be off what was seen: half a pixel, less where edges are soft
    and so say where they are between pixels."""
    low, high = float(surface.min()), float(surface.max())
    between = np.abs(surface - (low + high) / 2) < 0.4 * (high - low)
    inner = surface >= 0.5
    edge = inner & (cv2.erode(inner.astype(np.uint8), np.ones((3, 3), np.uint8)) == 0)
    return 0.25 if between.sum() > 0.3 * edge.sum() else 0.5


def without_specks(mask: Booleans, least: float) -> Booleans:
    """The mask without parts and without holes of fewer than `least` pixels."""
    return without_holes(~without_holes(~mask, least, 8), least)


def without_holes(mask: Booleans, least: float, connectivity: int = 4) -> Booleans:
    """The mask with holes of fewer than `least` pixels filled; itself if there are none."""
    _, labels, stats, _ = cv2.connectedComponentsWithStats(
        (~mask).astype(np.uint8), connectivity=connectivity
    )
    small = stats[:, cv2.CC_STAT_AREA] < least
    small[0] = False
    return mask | small[labels] if small.any() else mask
