"""Buildings of an extract as objects: the smallest rectangles around their outlines."""

from __future__ import annotations

import math

import numpy as np

from roadlang.api import FoundObject
from roadlang.geometry import Floats
from roadlang_formats.local_projection import LocalProjection

from .records import OsmExtract

_SMALLEST = 1.0
"""Meters of a side."""


def buildings_of(extract: OsmExtract, projection: LocalProjection) -> tuple[FoundObject, ...]:
    """One object for each closed way that is a building."""
    found = []
    for way in extract.ways:
        is_closed = len(way.nodes) > 3 and way.nodes[0] == way.nodes[-1]
        if not is_closed or way.tags.get("building", "no") == "no":
            continue
        nodes = [extract.nodes[id] for id in way.nodes[:-1]]
        corners = np.array([projection.point(node.latitude, node.longitude) for node in nodes])
        found.append(_object(corners))
    return tuple(found)


def _object(corners: Floats) -> FoundObject:
    """The rectangle along one of the sides that has the smallest area."""
    best = (math.inf, 0.0, np.zeros(2), np.zeros(2))
    for side in np.roll(corners, -1, axis=0) - corners:
        heading = math.atan2(float(side[1]), float(side[0]))
        cosine, sine = math.cos(heading), math.sin(heading)
        turned = corners @ np.array([[cosine, -sine], [sine, cosine]])
        low, high = turned.min(axis=0), turned.max(axis=0)
        area = float(np.prod(high - low))
        if area < best[0] - 1e-9:
            middle = (low + high) / 2.0 @ np.array([[cosine, sine], [-sine, cosine]])
            best = (area, heading, middle, high - low)
    _, heading, middle, size = best
    length, width = (max(float(side), _SMALLEST) for side in size)
    return FoundObject("building", float(middle[0]), float(middle[1]), length, width, heading)
