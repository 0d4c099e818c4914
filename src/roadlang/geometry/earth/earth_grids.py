"""Latitude and longitude of coordinates in the grids that maps and photos use most."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TypeAlias

from .local_projection import EQUATOR_RADIUS, LocalProjection

ToDegrees: TypeAlias = Callable[[float, float], tuple[float, float]]
"""From x and y to latitude and longitude in degrees."""

_GEOGRAPHIC = {4326, 4979, 4258, 4269, 4167, 7844}
"""WGS84, ETRS89, NAD83, NZGD2000, GDA2020: the same within 2 m."""
_MERCATOR = {3857, 3785, 900913}
_UTM = (
    (range(32601, 32661), 1, False),
    (range(32701, 32761), 1, True),
    (range(25828, 25839), 28, False),
    (range(26901, 26924), 1, False),
    (range(7846, 7860), 46, True),
)
"""EPSG codes, the zone of the first, whether they are of the south: of WGS84, ETRS89, NAD83 and
GDA2020."""
_SCALE, _EAST, _NORTH = 0.9996, 500_000.0, 10_000_000.0


def to_degrees(code: int) -> ToDegrees | None:
    """Of the grid with this EPSG code; None for one that is not known here.

    Known are latitude and longitude of the usual datums (x is the longitude), UTM of WGS84, ETRS89,
    NAD83 and GDA2020, and the Mercator projection of web maps (EPSG Guidance Note 7-2, 3.2.2).
    """
    if code in _GEOGRAPHIC:
        return _swapped
    if code in _MERCATOR:
        return _from_web_mercator
    for codes, first, south in _UTM:
        if code in codes:
            return _utm(code - codes[0] + first, south)
    return None


def _swapped(x: float, y: float) -> tuple[float, float]:
    return y, x


def _from_web_mercator(x: float, y: float) -> tuple[float, float]:
    latitude = math.atan(math.sinh(y / EQUATOR_RADIUS))
    return math.degrees(latitude), math.degrees(x / EQUATOR_RADIUS)


def _utm(zone: int, south: bool) -> ToDegrees:
    projection = LocalProjection(0.0, 6.0 * zone - 183.0)

    def degrees(x: float, y: float) -> tuple[float, float]:
        north = y - _NORTH if south else y
        return projection.place((x - _EAST) / _SCALE, north / _SCALE)

    return degrees
