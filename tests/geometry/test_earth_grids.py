"""Grids of maps: the degrees of coordinates that an exact projection has made."""

from __future__ import annotations

import math

import pytest

from roadlang.geometry.earth.earth_grids import to_degrees
from tests.geometry.test_local_projection import kruger


@pytest.mark.parametrize(
    ("code", "meridian", "latitude", "longitude"),
    [(32632, 9.0, 48.1, 11.6), (25833, 15.0, 69.0, 12.1), (26910, -123.0, 1.0, -120.2),
     (32756, 153.0, -33.9, 151.2), (7855, 147.0, -42.9, 147.3), (32701, -177.0, -79.0, -179.5)],
)  # fmt: skip
def test_utm(code: int, meridian: float, latitude: float, longitude: float) -> None:
    x, y = kruger(latitude, longitude, meridian)
    south = 1e7 if latitude < 0 else 0.0
    found = to_degrees(code)
    assert found is not None
    place = found(500_000.0 + 0.9996 * x, south + 0.9996 * y)
    assert place == pytest.approx((latitude, longitude), abs=1e-8)


def test_web_mercator_and_degrees() -> None:
    """The corner of a tile at zoom 1 is at 85.0511 degrees."""
    mercator, degrees = to_degrees(3857), to_degrees(4326)
    assert mercator is not None
    assert degrees is not None
    half = math.pi * 6_378_137.0
    assert mercator(half, half) == pytest.approx((85.05112878, 180.0), abs=1e-8)
    assert degrees(11.6, 48.1) == (48.1, 11.6)


def test_other_grids_are_not_known_here() -> None:
    assert to_degrees(2056) is None
