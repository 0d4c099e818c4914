"""Networks of SUMO (`.net.xml`) from above: lanes with their shapes and widths."""

from __future__ import annotations

from collections.abc import Iterator

from roadlang_standard.svg import palette

from ..map_xml import MapElement, MapFile
from .shapes import PlanShape, points

_WIDTH = 3.2
"""Meters of a lane that states none, as in SUMO."""


def shapes(file: MapFile) -> Iterator[PlanShape]:
    """Junctions first, then lanes."""
    for junction in file.root.all("junction"):
        if junction.attributes.get("type") != "internal":
            outline = points(file, junction, "shape", "")
            if len(outline) > 2:
                yield PlanShape((outline,), palette.SURFACE, label=_label(junction))
    for edge in file.root.all("edge"):
        if edge.attributes.get("function") in ("internal", "connector"):
            continue
        for lane in edge.all("lane"):
            line = points(file, lane, "shape")
            if len(line) > 1:
                width = file.number(lane, "width", _WIDTH)
                yield PlanShape((line,), _color(lane, edge), max(width, 0.0), _label(lane))


def _label(element: MapElement) -> str:
    return f"{element.tag} {element.attributes.get('id', '')}".strip()


def _color(lane: MapElement, edge: MapElement) -> str:
    allowed = lane.attributes.get("allow", "").split()
    if edge.attributes.get("function") in ("crossing", "walkingarea") or allowed == ["pedestrian"]:
        return palette.LANES["sidewalk"]
    if allowed == ["bicycle"]:
        return palette.LANES["bike"]
    return palette.LANES["bus"] if "bus" in allowed else palette.SURFACE
