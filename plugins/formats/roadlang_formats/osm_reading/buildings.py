"""Buildings of an extract as objects: the smallest rectangles around their outlines."""

from __future__ import annotations

import numpy as np

from roadlang.api import FoundObject
from roadlang.geometry import Floats
from roadlang.geometry.earth.local_projection import LocalProjection
from roadlang_formats.rectangles import smallest_rectangle

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
    x, y, length, width, heading = smallest_rectangle(corners)
    return FoundObject("building", x, y, max(length, _SMALLEST), max(width, _SMALLEST), heading)
