"""Lanelet2 maps (`.osm` with lanelets) from above."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from roadlang.geometry import Floats
from roadlang.geometry.earth.local_projection import LocalProjection
from roadlang_standard.svg import palette

from ..map_xml import MapElement, MapFile
from .shapes import PlanShape, joined

_COLORS = {
    "walkway": palette.LANES["sidewalk"],
    "crosswalk": palette.LANES["sidewalk"],
    "bicycle_lane": palette.LANES["bike"],
    "bus_lane": palette.LANES["bus"],
}
_LINE = 0.15
"""Meters of a marking."""


def is_lanelet_map(file: MapFile) -> bool:
    """Whether an `.osm` file is a Lanelet2 map, not an extract of OpenStreetMap."""
    return any(_tags(found).get("type") == "lanelet" for found in file.root.all("relation"))


def shapes(file: MapFile) -> Iterator[PlanShape]:
    """Lanelets, then the lines that are painted between them."""
    ways = _ways(file)
    for relation in file.root.all("relation"):
        tags = _tags(relation)
        if tags.get("type") != "lanelet":
            continue
        left, right = (_border(file, relation, ways, role) for role in ("left", "right"))
        if np.hypot(*(left[0] - right[0])) > np.hypot(*(left[0] - right[-1])):
            right = right[::-1]
        color = _COLORS.get(tags.get("subtype", ""), palette.SURFACE)
        label = f"lanelet {relation.attributes.get('id', '')}"
        yield PlanShape((joined(left, right),), color, label=label)
    for way in file.root.all("way"):
        if _tags(way).get("type") in ("line_thin", "line_thick", "stop_line"):
            line = ways[file.attribute(way, "id")]
            if len(line) > 1:
                yield PlanShape((line,), palette.MARKING, _LINE)


def _border(file: MapFile, relation: MapElement, ways: Mapping[str, Floats], role: str) -> Floats:
    """The ways of a border, one after the other."""
    parts = [
        ways[member.attributes.get("ref", "")]
        for member in relation.all("member")
        if member.attributes.get("role") == role and member.attributes.get("ref") in ways
    ]
    line = np.concatenate(parts) if parts else np.empty((0, 2))
    if len(line) < 2:
        raise file.fault(relation, f"this lanelet has no {role} border")
    return line


def _ways(file: MapFile) -> dict[str, Floats]:
    places = _places(file)
    found = {}
    for way in file.root.all("way"):
        nodes = [file.attribute(node, "ref") for node in way.all("nd")]
        known = [places[node] for node in nodes if node in places]
        found[file.attribute(way, "id")] = np.array(known).reshape(-1, 2)
    return found


def _places(file: MapFile) -> dict[str, Floats]:
    """Of nodes: their local coordinates where all have them, else meters around their mean."""
    local: dict[str, Floats] = {}
    degrees: dict[str, Floats] = {}
    for node in file.root.all("node"):
        id, tags = (
            file.attribute(node, "id"),
            {tag.attributes.get("k"): tag for tag in node.all("tag")},
        )
        if "local_x" in tags and "local_y" in tags:
            x, y = (file.number(tags[name], "v") for name in ("local_x", "local_y"))
            local[id] = np.array((x, y))
        degrees[id] = np.array((file.number(node, "lat"), file.number(node, "lon")))
    if len(local) == len(degrees):
        return local
    table = np.array(list(degrees.values()))
    projection = LocalProjection(*table.mean(axis=0).tolist())
    return {id: np.array(projection.point(*place)) for id, place in degrees.items()}


def _tags(element: MapElement) -> dict[str, str]:
    return {tag.attributes.get("k", ""): tag.attributes.get("v", "") for tag in element.all("tag")}
