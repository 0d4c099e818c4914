"""Features of GeoJSON (RFC 7946) as ways: lines are streets, polygons may be buildings."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from roadlang.api import DiagnosticError

from .degrees import why_no_place
from .osm_reading.records import OsmExtract, OsmNode, OsmWay

Fault = Callable[[str], DiagnosticError]
_DIGITS = 7
"""Decimals of degrees: points within about a centimeter become one."""
_LINES = {"LineString": 0, "MultiLineString": 1, "Polygon": 1, "MultiPolygon": 2}
"""Types of geometries, and how deeply their lists of points are nested."""
_LARGEST = 1e8
"""Largest absolute value of a coordinate that is a number at all."""


def ways_of(content: Any, fault: Fault) -> OsmExtract:
    """Nodes where points coincide, and ways with the properties of their features as tags. A line
    without `highway` is a residential street."""
    nodes: dict[str, OsmNode] = {}
    ways = []
    for number, feature in enumerate(_features(content, fault), start=1):
        geometry = feature.get("geometry") or {}
        kind = geometry.get("type") if isinstance(geometry, dict) else None
        if kind is not None and not isinstance(kind, str):
            raise fault(f"feature {number} has a geometry whose type is not a string")
        if kind not in _LINES:
            continue
        tags = _tags(feature.get("properties"))
        if "Polygon" in kind:
            tags = {key: value for key, value in tags.items() if key != "highway"}
        else:
            tags.setdefault("highway", "residential")
        for line in _lines(geometry, kind, number, fault):
            ids = tuple(_node(point, nodes, number, fault) for point in line)
            ways.append(OsmWay(ids, tags, str(number), f"a line of feature {number}"))
    return OsmExtract(nodes, tuple(ways))


def _features(content: Any, fault: Fault) -> Iterator[Mapping[str, Any]]:
    kind = content.get("type") if isinstance(content, dict) else None
    if kind == "Feature":
        listed = [content]
    elif kind == "FeatureCollection" and isinstance(content.get("features"), list):
        listed = content["features"]
    else:
        raise fault("it is not a GeoJSON FeatureCollection")
    for number, feature in enumerate(listed, start=1):
        if not isinstance(feature, dict):
            raise fault(f"feature {number} is not an object")
        yield feature


def _tags(properties: Any) -> dict[str, str]:
    if not isinstance(properties, dict):
        return {}
    found = properties.items()
    return {
        str(key): "yes" if value is True else str(value)
        for key, value in found
        if isinstance(value, str | int | float) and value is not False
    }


def _lines(
    geometry: Mapping[str, Any], kind: str, number: int, fault: Fault
) -> Iterator[list[Any]]:
    """The lists of points of a geometry. Of a polygon only the first, its outline: the others are
    holes."""
    coordinates = geometry.get("coordinates")
    if "Polygon" not in kind:
        yield from _nested(coordinates, _LINES[kind], number, fault)
        return
    for rings in _nested(coordinates, _LINES[kind] - 1, number, fault):
        yield from _nested(rings[:1], 1, number, fault)


def _nested(coordinates: Any, depth: int, number: int, fault: Fault) -> Iterator[list[Any]]:
    """The lists at a depth of nested lists."""
    if not isinstance(coordinates, list):
        raise fault(f"the coordinates of feature {number} are not a list")
    if not depth:
        yield coordinates
        return
    for part in coordinates:
        yield from _nested(part, depth - 1, number, fault)


def _node(point: Any, nodes: dict[str, OsmNode], number: int, fault: Fault) -> str:
    """The id of the node at a point, longitude first."""
    numbers = point[:2] if isinstance(point, list) else []
    if len(numbers) != 2 or not all(
        type(x) in (int, float) and abs(x) <= _LARGEST for x in numbers
    ):
        raise fault(f"feature {number} has a point that is not a pair of numbers")
    longitude, latitude = (round(float(x), _DIGITS) for x in numbers)
    reason = why_no_place(latitude, longitude)
    if reason:
        raise fault(f"feature {number}: {reason}")
    # Lines are cut at the antimeridian: both of their parts have this point.
    longitude = 180.0 if longitude == -180.0 else longitude
    id = f"{latitude} {longitude}"
    nodes.setdefault(id, OsmNode(latitude, longitude, {}))
    return id
