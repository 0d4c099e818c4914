"""Objects as polygons, which SUMO draws; vehicles do not see them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element, indent, tostring

import numpy as np

from ..opendrive.elements import put
from .network import shape

if TYPE_CHECKING:
    from roadlang.api import SceneActor


def polygons_text(things: Sequence[SceneActor]) -> str:
    """The `.add.xml`: the footprint of each object."""
    root = Element("additional")
    for thing in things:
        cos, sin = math.cos(thing.heading), math.sin(thing.heading)
        half = 0.5 * np.array([thing.length, thing.width])
        corners = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)]) * half
        points = corners @ np.array([[cos, sin], [-sin, cos]]) + (thing.x, thing.y)
        put(root, "poly", id=thing.name, type=thing.kind, color="128,128,128", fill=1, layer=1,
            shape=shape(points))  # fmt: skip
    indent(root, " ")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{tostring(root, encoding="unicode")}\n'
