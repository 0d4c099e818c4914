"""Light, weather and grip of the engine's world, by hand."""

from __future__ import annotations

import math
from typing import Any

import pytest

from roadlang_godot.build.sky import sun_at, world_settings

CLEAR = {"cloud": 0.0, "rain": 0.0, "snow": 0.0, "visibility": 20000.0}


@pytest.mark.parametrize(
    ("hours", "elevation", "azimuth"),
    [(6, 0, 0), (12, 58, -90), (18, 0, -180), (24, -58, -270), (8, 29, -30)],
)
def test_the_sun_is_up_in_the_east_at_six_and_in_the_south_at_noon(
    hours: float, elevation: float, azimuth: float
) -> None:
    """58 degrees at most; halfway at a third of the morning, for sin 30 degrees is one half."""
    sun = sun_at(hours)
    assert math.degrees(sun["sun_elevation"]) == pytest.approx(elevation, abs=1e-6)
    assert math.degrees(sun["sun_azimuth"]) == pytest.approx(azimuth)


@pytest.mark.parametrize(
    ("weather", "changed"),
    [
        ("clear", {}),
        ("cloudy", {"cloud": 0.8, "visibility": 12000.0}),
        ("overcast", {"cloud": 1.0, "visibility": 8000.0}),
        ("rain", {"cloud": 0.9, "rain": 0.6, "visibility": 900.0}),
        ("snow", {"cloud": 0.9, "snow": 0.9, "visibility": 1200.0}),
        ("fog", {"cloud": 0.8, "visibility": 120.0}),
    ],
)
def test_what_a_weather_implies(weather: str, changed: dict[str, float]) -> None:
    settings = world_settings({"weather": weather})
    assert settings == CLEAR | changed | sun_at(10.0)


@pytest.mark.parametrize(
    ("world", "expected"),
    [
        ({}, CLEAR),
        ({"weather": "fog", "visibility": 30.0}, {"visibility": 30}),
        ({"weather": "snow", "friction": 0.4}, {"visibility": 1200}),
        # 10 mm/h: 1 - 1/e as dense as a cloudburst
        ({"rain": 10e-3 / 3600}, {"rain": 0.632, "cloud": 0.9}),
        # 0.5 mm/h: 4.9 %, four times as much of the sky is covered
        ({"rain": 0.5e-3 / 3600}, {"rain": 0.0488, "cloud": 0.9 * 4 * 0.0488}),
        ({"weather": "snow", "rain": 0.0}, {"rain": 0.0, "cloud": 0.9}),
        ({"time_of_day": 12 * 3600.0}, {"sun_azimuth": -math.pi / 2}),
        ({"sun": {"azimuth": 1.0, "elevation": 0.2}}, {"sun_azimuth": 1.0, "sun_elevation": 0.2}),
        ({"sun": {"azimuth": None}}, {"sun_azimuth": -math.pi / 3}),
        ({"sun": {"elevation": 0.0}}, {"sun_azimuth": -math.pi / 3, "sun_elevation": 0.0}),
    ],
    ids=str,
)  # fmt: skip
def test_what_a_scene_says_goes_before_what_it_implies(
    world: dict[str, Any], expected: dict[str, float]
) -> None:
    settings = world_settings(world)
    assert {key: settings[key] for key in expected} == pytest.approx(expected, abs=1e-3)
