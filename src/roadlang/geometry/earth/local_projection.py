"""Latitude and longitude as meters around an origin: the transverse Mercator projection.

Snyder, "Map Projections: A Working Manual" (USGS 1395, 1987), equations 8-9 to 8-15, on the
ellipsoid of WGS84, with a scale of 1 at the meridian of the origin. Within 50 km of the origin
lengths are true to 0.01 %.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..arrays import Floats

EQUATOR_RADIUS = 6_378_137.0
"""Meters, of the ellipsoid of WGS84."""
_SQUARED = 0.00669437999014
"""The square of the eccentricity."""

_CORRECTIONS = 8
"""Each leaves less than a tenth of the error, within 50 km and up to 80 degrees."""


@dataclass(frozen=True, slots=True)
class LocalProjection:
    """The projection whose (0, 0) is at `latitude` and `longitude`, degrees."""

    latitude: float
    longitude: float

    def point(self, latitude: float, longitude: float) -> tuple[float, float]:
        """Meters east and north of the origin of a place in degrees."""
        phi = math.radians(latitude)
        sine, cosine, tangent = math.sin(phi), math.cos(phi), math.tan(phi)
        second = _SQUARED / (1.0 - _SQUARED)
        n = EQUATOR_RADIUS / math.sqrt(1.0 - _SQUARED * sine * sine)
        t, c = tangent * tangent, second * cosine * cosine
        away = math.remainder(longitude - self.longitude, 360.0)
        a = math.radians(away) * cosine
        x = a + (1.0 - t + c) * a**3 / 6.0
        x += (5.0 - 18.0 * t + t * t + 72.0 * c - 58.0 * second) * a**5 / 120.0
        y = a * a / 2.0 + (5.0 - t + 9.0 * c + 4.0 * c * c) * a**4 / 24.0
        y += (61.0 - 58.0 * t + t * t + 600.0 * c - 330.0 * second) * a**6 / 720.0
        north = _meridian(phi) - _meridian(math.radians(self.latitude)) + n * tangent * y
        return n * x, north

    def place(self, x: float, y: float) -> tuple[float, float]:
        """Latitude and longitude in degrees of a point in meters, by repeated correction."""
        latitude, longitude = self.latitude, self.longitude
        for _ in range(_CORRECTIONS):
            east, north = self.point(latitude, longitude)
            sine, cosine = math.sin(math.radians(latitude)), math.cos(math.radians(latitude))
            n = EQUATOR_RADIUS / math.sqrt(1.0 - _SQUARED * sine * sine)
            r = n * (1.0 - _SQUARED) / (1.0 - _SQUARED * sine * sine)
            latitude += math.degrees((y - north) / r)
            longitude += math.degrees((x - east) / (n * cosine))
        return latitude, longitude

    def longitudes_and_latitudes(self, points: Floats) -> Floats:
        """(n, 2) longitudes and latitudes in degrees of points (n, 2) in meters; on the far side
        of the antimeridian longitudes go on beyond 180 or -180."""
        return np.array([self.place(x, y)[::-1] for x, y in points.tolist()]).reshape(-1, 2)


def _meridian(phi: float) -> float:
    """Meters along the meridian from the equator to a latitude in radians (3-21)."""
    e2, e4, e6 = _SQUARED, _SQUARED**2, _SQUARED**3
    return EQUATOR_RADIUS * (
        (1.0 - e2 / 4.0 - 3.0 * e4 / 64.0 - 5.0 * e6 / 256.0) * phi
        - (3.0 * e2 / 8.0 + 3.0 * e4 / 32.0 + 45.0 * e6 / 1024.0) * math.sin(2.0 * phi)
        + (15.0 * e4 / 256.0 + 45.0 * e6 / 1024.0) * math.sin(4.0 * phi)
        - 35.0 * e6 / 3072.0 * math.sin(6.0 * phi)
    )
