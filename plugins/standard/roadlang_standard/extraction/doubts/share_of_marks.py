"""The roads of a drawing are much of what is drawn in it: a line that is little of what a picture
shows belongs to a page of text, a screen or a diagram."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from ..colors.local_spread import local_spread
from ..colors.tones import Image
from ..networks.found_network import NO_ROAD, FoundNetwork

_LITTLE, _MUCH = 0.17, 0.22
"""Share of the edges in a picture that are at roads: below `_LITTLE` they are doubted in full, from
`_MUCH` on they are not. Of 130 drawings of roads all have more than .35; of 178 tiles in eleven
styles two are below .22, in which few streets were found; lines of screens have .08 to .17."""
_RIM = 3
"""Pixels this far beside a road still belong to it: smoothed edges, and lines around it."""
_AS_STRONG = 0.5
"""Edges count if they are at least this share as strong as those of most roads."""
_STRONGEST, _CLEAR = 0.995, 0.3
"""Edges that are at least `_CLEAR` as strong as the quantile `_STRONGEST` of the picture always
count: between wide roads and names, others are stronger than most of what is at a road."""
_LEAST, _SURELY = 8, 25
"""Differences of neighbors below `_LEAST` gray levels are no edges, and from `_SURELY` on they are,
unless the picture has stronger ones."""
_MOST_AT_ROADS = 0.75
"""The quantile of what is at the rims of roads that says how strong their edges are."""


def sure_by_share(found: FoundNetwork, image: Image) -> float:
    """How sure the roads of a drawing are by the share that they have in the edges of the picture
    (h, w, 3) in which they were found."""
    spread = local_spread(image)
    near, rim = _at_roads(found, spread.shape)
    edges = spread > _least_edge(spread, rim)
    if found.printed is not None:
        beside = np.ones((2 * _RIM + 1,) * 2, np.uint8)
        edges &= near | (cv2.dilate(found.printed.view(np.uint8), beside) == 0)
    share = int(np.count_nonzero(edges & near)) / max(1, int(np.count_nonzero(edges)))
    return float(np.interp(share, (_LITTLE, _MUCH), (NO_ROAD, 1.0)))


def _at_roads(
    found: FoundNetwork, shape: tuple[int, ...]
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """What is on roads or at them (h, w), and what of that is near their sides (h, w)."""
    near, inner = np.zeros(shape, np.uint8), np.zeros(shape, np.uint8)
    for road in found.roads:
        line = [np.round(road.points * 16).astype(np.int32)]
        width = road.usual_width
        thick = int(np.ceil(width + 2 * _RIM))
        cv2.polylines(near, line, road.closed, 1, thick, shift=4)
        if width > 3 * _RIM:
            cv2.polylines(inner, line, road.closed, 1, int(width - 2 * _RIM), shift=4)
    return near > 0, near > inner


def _least_edge(spread: Image, rim: NDArray[np.bool_]) -> float:
    """How many gray levels neighbors differ by at an edge that counts."""
    clear = max(_SURELY, _CLEAR * _quantile(spread, _STRONGEST))
    if not rim.any():
        return clear
    return max(_LEAST, min(clear, _AS_STRONG * _quantile(spread[rim], _MOST_AT_ROADS)))


def _quantile(values: Image, share: float) -> float:
    """The quantile of values 0..255; much faster for a picture than by sorting."""
    counts = np.cumsum(np.bincount(values.ravel(), minlength=256))
    return float(np.searchsorted(counts, share * counts[-1]))
