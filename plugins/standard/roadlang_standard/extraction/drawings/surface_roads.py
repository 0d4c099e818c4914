"""Roads of a mask: skeleton, graph, tidy, draw."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..doubts.drawn_confidence import with_doubts
from ..graphs.border_exits import lead_out
from ..graphs.dead_end_stubs import drop_border_forks, drop_corners, lengthen_square_ends, stubs
from ..graphs.graph import Graph
from ..graphs.graph_cleanup import contract, drop_crumbs, drop_loops, extend_to_border, join, prune
from ..graphs.linking import link
from ..graphs.oblique import join_oblique_crossings
from ..graphs.overpasses import join_overpasses
from ..graphs.square_stubs import add_square_stubs
from ..graphs.thin_strokes import drop_thin_strokes
from ..graphs.tracing import trace
from ..masks.mask_parts import without_specks
from ..masks.skeleton import skeleton
from ..networks.drafting import Draft, draft, width_within
from ..networks.found_network import FoundNetwork

Layer = NDArray[np.float32]
_WAVES, _ALL_WAVES = 2.0, 0.5
"""Shortest wavelengths of center lines, in widths: of smooth curves, and of lines as traced."""
_FINE = 4.0
"""Lines whose usual width in pixels is below this hardly survive the blur of a mask."""
_TWINS = 0.5
"""Junctions closer than this many widths are one."""
_FULL, _OFTEN = 0.03, 40
"""The skeleton of noise fills at least `_FULL` of the picture, and has a dead end in every `_OFTEN`
of its pixels."""
_LEFT_OUT = "short marks, such as names and arrows, were left out"
_BRIDGED, _DEAREST = 16.0, 0.9
"""Usual widths of road that a bridge across what hides it may span, and its mean cost a pixel."""
_NAME = 110.0
"""Names on narrow roads are up to so long, in pixels: letters do not shrink with the road."""


@dataclass(frozen=True)
class Cover:
    """What hides roads, such as the names on a map: where it is (h, w), and how likely it is that a
    road goes on unseen at each pixel (h, w), 0..1."""

    mask: Booleans
    hidden: Layer
    widest: float
    """width of the widest roads, pixels"""
    drawn: bool = False
    """whether what is short and thin may be an arrow or a scale bar, as in a drawing"""


def roads_of_surface(
    surface: Layer,
    method: str,
    spline: bool = True,
    width: float | None = None,
    least: float | None = None,
    specks: float = 12.0,
    cover: Cover | None = None,
) -> FoundNetwork:
    """The road network of a clean surface (h, w), 0..1, whose half level is the road edge.

    Dead ends shorter than `least` pixels (by default the usual width) go; so do parts and holes
    of fewer than `specks` square pixels. Under a `cover` dead ends are joined, and curves are
    smooth.
    """
    mask = without_specks(surface >= 0.5, specks)
    lines = skeleton(mask)
    while cover is None and _is_noise(lines) and specks < 1e4:
        specks *= 4
        surface = cv2.GaussianBlur(surface, (0, 0), 2.0)
        mask = without_specks(surface >= 0.5, specks)
        lines = skeleton(mask)
    graph = trace(lines)
    inner = cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, 5)
    thin = (
        drop_thin_strokes(graph, inner) if least is None and (cover is None or cover.drawn) else 0
    )
    typical, led_out = _tidy(graph, mask, inner, least, cover)
    leaving = typical if cover is None else max(typical, cover.widest)
    seen = mask if cover is None else None
    extend_to_border(graph, (mask.shape[0], mask.shape[1]), 0.7 * leaving + 2, led_out, seen)
    settings = Draft(
        typical,
        _WAVES if spline else _ALL_WAVES,
        0.0,
        _accuracy(surface),
        width,
        fair=spline,
        covered=None if cover is None else cover.mask,
        twins=_TWINS if cover is None else 0.0,
    )
    score = cv2.GaussianBlur(_seen(mask, typical).astype(np.float32), (0, 0), 0.8)
    drafted = draft(graph, surface, score, settings, method)
    found = with_doubts(drafted, drawn=cover is None, measured=width is None)
    return replace(found, remarks=(*found.remarks, _LEFT_OUT)) if thin else found


def _tidy(
    graph: Graph, mask: Booleans, inner: Layer, least: float | None, cover: Cover | None
) -> tuple[float, set[int]]:
    """Clean the graph of a mask's skeleton, in place; the usual width of its roads, pixels, and the
    nodes at which they leave the picture. `inner` (h, w): distance to the edge of the mask."""
    typical = width_within(graph, inner)
    drop_corners(graph, inner, typical)
    if cover is not None:
        drop_border_forks(graph, inner)
    short = []
    if least is None:
        short = [*add_square_stubs(graph, mask, typical), *stubs(graph, inner, typical)]
    contract(graph, 1.2 * typical)
    shortest = 1.1 * typical if least is None else least
    prune(graph, shortest, mask.shape, margin=0.6 * typical + 2, sure=short)
    join(graph)
    if cover is not None:
        _bridge(graph, cover, typical, shortest)
    else:
        join_overpasses(graph, typical, mask.shape)
    join_oblique_crossings(graph, typical)
    drop_crumbs(graph, min(2 * typical, 0.5 * max(mask.shape)))
    typical = width_within(graph, inner)
    led_out = lead_out(graph, mask, inner, typical)
    lengthen_square_ends(graph, mask, typical)
    return typical, led_out


def _bridge(graph: Graph, cover: Cover, width: float, shortest: float) -> None:
    """Join dead ends under a cover, in place; stubs shorter than `shortest` pixels go."""
    link(graph, cover.hidden, max(_BRIDGED * width, _NAME), _DEAREST, width)
    drop_loops(graph, 4 * width)
    contract(graph, 1.2 * width)
    prune(graph, shortest, cover.mask.shape, margin=0.6 * width + 2)
    join(graph)


def _is_noise(thin: Booleans) -> bool:
    """Whether a skeleton fills a large picture more than roads do, and ends often, as the streets
    of a town do not: it is smoothed first."""
    if thin.size <= 100_000 or thin.mean() <= _FULL:
        return False
    pixels = thin.view(np.uint8)
    around = cv2.boxFilter(pixels, -1, (3, 3), normalize=False, borderType=cv2.BORDER_CONSTANT)
    ends = np.count_nonzero((around <= 2) & thin)
    return bool(np.count_nonzero(thin) < _OFTEN * ends)


def _seen(mask: Booleans, typical: float) -> NDArray[np.uint8]:
    """The mask, of lines thinner than `_FINE` pixels with their neighbors: a road that is drawn a
    pixel wide is as sure as others."""
    seen = mask.view(np.uint8)
    return seen if typical >= _FINE else np.asarray(cv2.dilate(seen, np.ones((3, 3), np.uint8)))


def _accuracy(surface: Layer) -> float:
    """How far in pixels a curve may be off what was seen: half a pixel, less where edges are soft
    and so say where they are between pixels."""
    low, high = float(surface.min()), float(surface.max())
    between = np.abs(surface - (low + high) / 2) < 0.4 * (high - low)
    inner = surface >= 0.5
    edge = inner & (cv2.erode(inner.astype(np.uint8), np.ones((3, 3), np.uint8)) == 0)
    return 0.25 if np.count_nonzero(between) > 0.3 * np.count_nonzero(edge) else 0.5
