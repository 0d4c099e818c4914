"""Lines and areas on Earth as geometries of GeoJSON (RFC 7946), cut at the antimeridian."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..arrays import Floats
from .antimeridian import cut_area, cut_line

_DIGITS = 9
"""Decimals of degrees: a tenth of a millimeter."""


def line_geometry(line: Floats, digits: int = _DIGITS) -> dict[str, object]:
    """Of a line (n, 2) of longitudes and latitudes, as `cut_line` takes them."""
    parts = [_numbers(part, digits) for part in cut_line(line)]
    if len(parts) == 1:
        return {"type": "LineString", "coordinates": parts[0]}
    return {"type": "MultiLineString", "coordinates": parts}


def area_geometry(rings: Sequence[Floats], digits: int = _DIGITS) -> dict[str, object]:
    """Of an area of rings (n, 2) of longitudes and latitudes, as `cut_area` takes them."""
    parts = [[_numbers(ring, digits) for ring in part] for part in cut_area(rings)]
    if len(parts) == 1:
        return {"type": "Polygon", "coordinates": parts[0]}
    return {"type": "MultiPolygon", "coordinates": parts}


def _numbers(points: Floats, digits: int) -> list[list[float]]:
    return [[round(number, digits) for number in point] for point in np.asarray(points).tolist()]
