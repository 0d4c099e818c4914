"""Roads of a mask: skeleton, graph, tidy, draw."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from .clean import contract, drop_crumbs, extend_to_border, join, prune
from .drafting import Draft, draft, usual_width_of
from .found import FoundNetwork
from .graph import trace
from .skeleton import skeleton

Layer = NDArray[np.float32]


def roads_of_surface(
    surface: Layer,
    method: str,
    spline: bool = True,
    width: float | None = None,
    least: float | None = None,
    specks: float = 12.0,
    waves: float = 2.0,
    tolerance: float = 0.1,
) -> FoundNetwork:
    """The road network of a clean surface (h, w), 0..1, whose half level is the road edge.

    Dead ends shorter than `least` pixels (by default the usual width) go; so do parts and holes
    of fewer than `specks` square pixels.
    """
    mask = without_specks(surface >= 0.5, specks)
    graph = trace(skeleton(mask))
    usual = usual_width_of(graph, mask)
    contract(graph, 1.2 * usual)
    prune(graph, least if least is not None else 1.1 * usual, mask.shape, margin=0.6 * usual + 2)
    join(graph)
    drop_crumbs(graph, min(2 * usual, 0.5 * max(mask.shape)))
    usual = usual_width_of(graph, mask)
    extend_to_border(graph, (mask.shape[0], mask.shape[1]), 0.7 * usual + 2)
    manner = Draft(usual, waves if spline else 0.5, tolerance, width)
    score = cv2.GaussianBlur(mask.astype(np.float32), (0, 0), 0.8)
    return draft(graph, surface, score, manner, method)


def without_specks(mask: NDArray[np.bool_], least: float) -> NDArray[np.bool_]:
    """The mask without parts and without holes of fewer than `least` pixels."""
    for value in (True, False):
        seek = (mask if value else ~mask).astype(np.uint8)
        connectivity = 8 if value else 4
        count, labels, stats, _ = cv2.connectedComponentsWithStats(seek, connectivity=connectivity)
        small = np.flatnonzero(stats[:, cv2.CC_STAT_AREA] < least)
        small = small[small > 0]
        if len(small):
            flip = np.zeros(count, bool)
            flip[small] = True
            mask = mask ^ flip[labels]
    return mask
