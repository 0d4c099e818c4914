"""Where the net sees little, a plain road that ribbon filters are sure of is taken instead."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..colors.tones import Image
from ..doubts.box_lines import are_boxes
from ..networks.found_network import FoundNetwork, FoundRoad
from .aerial import Request, roads_of_photo
from .classical import roads_by_ribbons
from .photo_confidence import calibrated
from .road_net import Net
from .scale import resized

_LITTLE, _DOUBTED = 0.4, 0.65
"""Roads of the net are doubted if their length is below `_LITTLE` sides of the picture, or their
confidence is below `_DOUBTED`."""
_LONG, _SURE, _FEW = 0.5, 0.9, 3
"""Ribbons are accepted in place of such roads if they are at least `_LONG` sides of the picture
long, have a confidence of at least `_SURE`, and are at most `_FEW`."""
_BUSY = 4.0
"""A picture is busy, and its ribbons are never accepted, if their total length exceeds this many
sides of the picture. That of a lone road is about 1; fields and woods have 5 to 40."""
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
    # The frame of a screen or a window is a strip unlike both its sides, too.
    if not clear or are_boxes(believed, min(image.shape[:2])):
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
