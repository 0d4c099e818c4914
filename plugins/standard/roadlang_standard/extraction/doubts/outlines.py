"""Outlines of colored areas, as of a cartoon or of countries on a map, are not roads: the colors on
their two sides differ nearly everywhere."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np

from ..colors.tones import Image
from ..networks.connected_roads import connected_parts
from ..networks.found_network import NO_ROAD, FoundRoad
from .contrast_of_sides import LinePlaces, colors_at

_SOME, _MOST = 0.75, 0.85
"""Share of the length between two colors: up to `_SOME` lines may be roads, from `_MOST` on they
are outlines. Roads on 189 tiles of maps have up to .71 of theirs between areas of different colors,
in drawings up to .26."""
_DIFFER = 16.0
"""Two colors differ if they are more than this many gray levels apart."""
_BEYOND = 6.0
"""The colors are taken this many pixels beyond the edges of a road, where its casing has ended."""
_THIN = 0.02
"""Outlines are thinner than this share of the picture's shorter side; wider rings are roads around
a lake or a meadow."""


def sure_by_outlines(roads: Sequence[FoundRoad], image: Image) -> float:
    """How sure roads are by how much of their length has different colors on its two sides in the
    picture (h, w, 3), if they enclose areas."""
    if not _enclose(roads) or _width(roads) >= _THIN * min(image.shape[:2]):
        return 1.0
    places = LinePlaces.along(roads)
    soft = cv2.GaussianBlur(image, (3, 3), 0)
    off = (places.half + _BEYOND)[:, None] * places.across
    left, seen_left = colors_at(soft, places.points + off)
    right, seen_right = colors_at(soft, places.points - off)
    seen = seen_left & seen_right
    differ = np.linalg.norm(left - right, axis=1) > _DIFFER
    share = places.long[seen & differ].sum() / max(float(places.long[seen].sum()), 1.0)
    return float(np.interp(share, (_SOME, _MOST), (1.0, NO_ROAD)))


def _enclose(roads: Sequence[FoundRoad]) -> bool:
    """Whether there is a ring among the roads."""
    nodes = {node for road in roads for node in (road.start, road.end)}
    return len(roads) > len(nodes) - len(connected_parts(tuple(roads)))


def _width(roads: Sequence[FoundRoad]) -> float:
    """Mean width, pixels."""
    lengths = np.array([road.length for road in roads])
    widths = np.array([road.usual_width for road in roads])
    return float(lengths @ widths / max(float(lengths.sum()), 1e-9))
