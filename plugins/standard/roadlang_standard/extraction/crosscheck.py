"""Where the net sees little, a plain road that ribbon filters are sure of is taken instead."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .aerial import Request, roads_of_photo
from .classical import roads_by_ribbons
from .found_network import FoundNetwork, FoundRoad
from .photo_confidence import calibrated
from .road_net import Net
from .scale import resized
from .tones import Image

_LITTLE, _DOUBTED = 0.4, 0.65
"""Roads shorter than this share of the picture's side, or less sure, are doubted."""
_LONG, _SURE, _FEW = 0.5, 0.9, 3
"""Ribbons are believed if so long, so sure and so few: in a busy picture they never are."""
_BUSY = 4.0
"""A picture is busy if its ribbons are so many times as long in all as its side: a lone road's are
about as long as the side, those of fields and woods 5 to 40 times."""
_PIXELS = 1_000_000


def checked_roads(image: Image, request: Request, net: Net) -> FoundNetwork:
    """The roads of a photo (h, w, 3) as the net sees them, cross-checked where that is little.

    A clear road on bare ground looks like no photo that the net has learned from. Hints decide
    without a check.
    """
    found = roads_of_photo(image, request, net)
    hinted = request != Request(meters_per_pixel=request.meters_per_pixel)
    side = max(image.shape[:2])
    if hinted:
        return calibrated(found, doubt_alone=False)
    if _length(found.roads) >= _LITTLE * side and found.confidence >= _DOUBTED:
        return calibrated(found, doubt_alone=True)
    ribbons = _ribbons(image)
    believed = tuple(road for road in ribbons.roads if road.confidence >= _SURE)
    clear = len(ribbons.roads) <= _FEW and _length(believed) >= _LONG * side
    if not clear:
        return calibrated(found, doubt_alone=True)
    remark = "the neural network found little: a strip unlike both its sides was taken for a road"
    node_ids = {road.start for road in believed} | {road.end for road in believed}
    order = {node: index for index, node in enumerate(sorted(node_ids))}
    roads = tuple(replace(r, start=order[r.start], end=order[r.end]) for r in believed)
    nodes = ribbons.nodes[sorted(node_ids)]
    return replace(ribbons, roads=roads, nodes=nodes, remarks=(*ribbons.remarks, remark))


def _ribbons(image: Image) -> FoundNetwork:
    """What the filters find unless the picture is busy; in a smaller copy of a large one, for they
    are slow."""
    scale = min(1.0, float(np.sqrt(_PIXELS / (image.shape[0] * image.shape[1]))))
    found = roads_by_ribbons(resized(image, scale), _BUSY)
    return found if scale == 1 else found.scaled(1 / scale, image.shape[:2])


def _length(roads: tuple[FoundRoad, ...]) -> float:
    return sum(road.length for road in roads)
