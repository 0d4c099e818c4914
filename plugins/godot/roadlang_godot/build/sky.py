"""What a scene says of its world, as sun, air and grip of the engine."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

HIGHEST_SUN = math.radians(58)
STRONG_RAIN = 10e-3 / 3600
"""Meters a second: 10 mm/h, which looks two thirds as dense as a cloudburst."""
_SUN = ("azimuth", "elevation")
_WEATHER: dict[str, dict[str, float]] = {
    "clear": {"cloud": 0.0, "rain": 0.0, "snow": 0.0, "visibility": 20000.0},
    "cloudy": {"cloud": 0.8, "rain": 0.0, "visibility": 12000.0},
    "overcast": {"cloud": 1.0, "rain": 0.0, "visibility": 8000.0},
    "rain": {"cloud": 0.9, "rain": 0.6, "visibility": 900.0},
    "snow": {"cloud": 0.9, "rain": 0.0, "snow": 0.9, "visibility": 1200.0},
    "fog": {"cloud": 0.8, "rain": 0.0, "visibility": 120.0},
}


def world_settings(world: Mapping[str, Any]) -> dict[str, float]:
    """Settings of the engine's world; a value that a scene gives goes before what it implies."""
    settings = dict(_WEATHER["clear"])
    settings |= _WEATHER.get(str(world.get("weather", "clear")), {})
    hours = float(world.get("time_of_day", 10 * 3600.0)) / 3600.0
    settings |= sun_at(hours)
    if isinstance(world.get("visibility"), (int, float)):
        settings["visibility"] = float(world["visibility"])
    if isinstance(world.get("rain"), (int, float)):
        settings["rain"] = 1.0 - math.exp(-float(world["rain"]) / STRONG_RAIN)
        settings["cloud"] = max(settings["cloud"], 0.9 * min(1.0, 4.0 * settings["rain"]))
    sun: Mapping[str, Any] = world.get("sun") or {}
    return settings | {f"sun_{key}": float(sun[key]) for key in _SUN if sun.get(key) is not None}


def sun_at(hours: float) -> dict[str, float]:
    """Height and azimuth (counter-clockwise from east) of the sun: up in the east at six, south
    at noon."""
    turn = (hours - 6.0) / 12.0 * math.pi
    return {"sun_elevation": HIGHEST_SUN * math.sin(turn), "sun_azimuth": -turn}
