"""The OpenDRIVE file of a scene as Scenic reads it best."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING
from xml.etree import ElementTree

from ..opendrive.document import document

if TYPE_CHECKING:
    from collections.abc import Iterable

    from roadlang.api import Scene

_TOLERANCE = 0.005
_SAG = 0.02
"""Meters by which a chord between points may be off."""
_FEWEST, _MOST = 20, 200
"""Points of each piece of a reference line; 20 are Scenic's own number."""
_DRIVEN = "bidirectional"
"""A type of lanes for vehicles that Scenic does not take for such."""
_NARROWEST = 0.1
"""Meters: Scenic fails on a lane that has no width on some part of its road."""


def road_map(scene: Scene) -> tuple[str, int]:
    """The text of the map, and into how many points each piece of a reference line is to be cut."""
    root = ElementTree.fromstring(document(scene, "1.8", _TOLERANCE, "", "one_way_roads"))
    for road in root.iter("road"):
        for lane in road.iter("lane"):
            if lane.get("type") == _DRIVEN:
                lane.set("type", "driving")
            _widen(lane, float(road.get("length", 0.0)))
    text = ElementTree.tostring(root, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n', _points(root.iter("geometry"))


def _points(pieces: Iterable[ElementTree.Element]) -> int:
    """So many that the chords of all arcs and clothoids are close to them."""
    most = float(_FEWEST)
    for piece in pieces:
        length = float(piece.get("length", 0.0))
        for shape in piece:
            numbers = [
                float(shape.get(name, 0.0)) for name in ("curvature", "curvStart", "curvEnd")
            ]
            bend = max(map(abs, numbers))
            most = max(most, length * math.sqrt(bend / (8.0 * _SAG)) + 1.0)
    return min(_MOST, math.ceil(most))


def _widen(lane: ElementTree.Element, length: float) -> None:
    """Gives a lane a width everywhere. Its widths are linear pieces; there is one lane section."""
    pieces = lane.findall("width")
    rows = [[float(piece.get(name, 0.0)) for name in ("sOffset", "a", "b")] for piece in pieces]
    if not rows or min(a + min(0.0, b) * length for _, a, b in rows) > _NARROWEST:
        return
    ends = [start for start, _, _ in rows[1:]] + [length]
    for piece, (start, a, b), end in zip(pieces, rows, ends, strict=True):
        first, last = (max(_NARROWEST, width) for width in (a, a + b * (end - start)))
        piece.set("a", f"{first:.12g}")
        piece.set("b", f"{(last - first) / (end - start):.12g}")
