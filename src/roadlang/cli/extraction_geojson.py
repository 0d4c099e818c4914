"""The roads of a picture as GeoJSON: lines in longitude and latitude (RFC 7946)."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from ..geometry.earth.geojson_geometry import line_geometry
from ..geometry.earth.local_projection import LocalProjection
from ..ir.picture import Extraction, Picture
from .extraction_files import in_meters

_DIGITS = 8
"""Decimals of degrees: a millimeter."""


def as_geojson(picture: Picture, found: Extraction, origin: tuple[float, float]) -> str:
    """One feature a road, one a line of the file.

    `origin`: latitude and longitude in degrees of the lower left corner of the picture. Properties
    are named as in OpenStreetMap, so that maps show the lines as roads: `width` in meters;
    `confidence` is ours, 0 to 1.
    """
    projection = LocalProjection(*origin)
    features = [
        json.dumps(_feature(picture, edge, projection), allow_nan=False)
        for edge in found.network.edges
    ]
    inside = ",\n".join(features)
    return f'{{"type": "FeatureCollection", "features": [\n{inside}\n]}}\n'


def _feature(picture: Picture, edge: Any, projection: LocalProjection) -> dict[str, object]:
    points, widths = in_meters(picture, edge)
    return {
        "type": "Feature",
        "id": f"road {edge.id}",
        "properties": {
            "highway": "road",
            "width": round(float(np.median(widths)), 2),
            "length": round(edge.length, 2),
            "confidence": round(float(edge.confidence), 4),
        },
        "geometry": line_geometry(projection.longitudes_and_latitudes(points), _DIGITS),
    }
