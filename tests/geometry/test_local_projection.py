"""The projection of maps against another series for it, which is exact to micrometers."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry.earth.local_projection import LocalProjection

_RADIUS, _FLATTENING = 6_378_137.0, 1.0 / 298.257_223_563


def kruger(latitude: float, longitude: float, origin: float) -> tuple[float, float]:
    """Meters east of a meridian and north of the equator by Krüger's series in the third
    flattening (Karney, Transverse Mercator with an accuracy of a few nanometers, eqs. 7 to 12,
    35), to the fourth power."""
    n = _FLATTENING / (2.0 - _FLATTENING)
    rectifying = _RADIUS / (1.0 + n) * (1.0 + n**2 / 4.0 + n**4 / 64.0)
    alpha = (
        n / 2.0 - 2.0 * n**2 / 3.0 + 5.0 * n**3 / 16.0 + 41.0 * n**4 / 180.0,
        13.0 * n**2 / 48.0 - 3.0 * n**3 / 5.0 + 557.0 * n**4 / 1440.0,
        61.0 * n**3 / 240.0 - 103.0 * n**4 / 140.0,
        49561.0 * n**4 / 161280.0,
    )
    phi, away = math.radians(latitude), math.radians(longitude - origin)
    eccentricity = math.sqrt(_FLATTENING * (2.0 - _FLATTENING))
    sine = math.sin(phi)
    conformal = math.sinh(math.atanh(sine) - eccentricity * math.atanh(eccentricity * sine))
    xi = math.atan2(conformal, math.cos(away))
    eta = math.asinh(math.sin(away) / math.hypot(conformal, math.cos(away)))
    north = xi + sum(
        a * math.sin(2 * k * xi) * math.cosh(2 * k * eta) for k, a in enumerate(alpha, 1)
    )
    east = eta + sum(
        a * math.cos(2 * k * xi) * math.sinh(2 * k * eta) for k, a in enumerate(alpha, 1)
    )
    return rectifying * east, rectifying * north


LATITUDES = (-72.0, -33.9, -0.5, 0.0, 25.0, 48.1, 64.0, 80.0)


@pytest.mark.parametrize("latitude", LATITUDES)
@pytest.mark.parametrize("away", [-3.0, -0.2, 1.0, 2.5])
def test_beside_its_meridian_a_place_is_where_the_exact_projection_has_it(
    latitude: float, away: float
) -> None:
    projection = LocalProjection(10.0, 11.5)
    x, y = projection.point(latitude, 11.5 + away)
    east, north = kruger(latitude, 11.5 + away, 11.5)
    beyond = y - projection.point(latitude, 11.5)[1]
    assert x == pytest.approx(east, abs=2e-4)
    assert beyond == pytest.approx(north - kruger(latitude, 11.5, 11.5)[1], abs=3e-6)


@pytest.mark.parametrize("latitude", LATITUDES)
def test_along_its_meridian_lengths_are_true_to_a_millimeter(latitude: float) -> None:
    north = kruger(latitude, 11.5, 11.5)[1] - kruger(10.0, 11.5, 11.5)[1]
    assert LocalProjection(10.0, 11.5).point(latitude, 11.5) == pytest.approx((0, north), abs=1e-3)


def test_longitudes_go_on_at_the_date_line() -> None:
    found = LocalProjection(64.0, 179.9).point(64.0, -179.9)
    assert found == pytest.approx(LocalProjection(64.0, 0.0).point(64.0, 0.2))


@given(
    latitude=st.floats(-80.0, 80.0),
    longitude=st.floats(-180.0, 180.0),
    x=st.floats(-20_000.0, 20_000.0),
    y=st.floats(-20_000.0, 20_000.0),
)
def test_a_point_is_found_again_from_its_place(
    latitude: float, longitude: float, x: float, y: float
) -> None:
    projection = LocalProjection(latitude, longitude)
    assert projection.point(*projection.place(x, y)) == pytest.approx((x, y), abs=1e-4)
