"""A scene as the text of a GeoJSON file."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import TYPE_CHECKING

from roadlang.geometry.earth.geojson_geometry import area_geometry, line_geometry
from roadlang.geometry.earth.local_projection import LocalProjection

from .features import Feature, junction_features, lane_features, road_features, standing_features

if TYPE_CHECKING:
    from roadlang.api import Scene


def document(scene: Scene, origin: tuple[float, float], lanes: bool) -> str:
    """The collection of a scene whose (0, 0) is at `origin`: latitude and longitude, degrees. One
    feature a line; `lanes`: with the areas of lanes and junctions."""
    projection = LocalProjection(*origin)
    features = [_json(feature, projection) for feature in _features(scene, lanes)]
    inside = ",\n".join(json.dumps(feature, ensure_ascii=False) for feature in features)
    return f'{{"type": "FeatureCollection", "features": [\n{inside}\n]}}\n'


def _features(scene: Scene, lanes: bool) -> Iterator[Feature]:
    yield from road_features(scene)
    if lanes:
        yield from junction_features(scene)
        yield from lane_features(scene)
    yield from standing_features(scene.markings, "marking")
    yield from standing_features(scene.objects, "object")
    yield from standing_features(scene.agents, "agent")


def _json(feature: Feature, projection: LocalProjection) -> dict[str, object]:
    """RFC 7946, section 3.2."""
    lines = [projection.longitudes_and_latitudes(line) for line in feature.lines]
    geometry = area_geometry(lines) if feature.is_area else line_geometry(lines[0])
    return {
        "type": "Feature",
        "id": feature.id,
        "properties": feature.properties,
        "geometry": geometry,
    }
