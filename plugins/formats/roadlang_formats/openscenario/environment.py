"""Time of day, weather and friction of a scene."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any
from xml.etree.ElementTree import Element

from ..opendrive.elements import put

_DAY = "2020-06-21"
"""OpenSCENARIO wants a date; that of the longest day."""
_OKTAS = {
    "clear": "zeroOktas",
    "cloudy": "fourOktas",
    "overcast": "eightOktas",
    "rain": "eightOktas",
    "snow": "eightOktas",
    "fog": "eightOktas",
}
_RAIN, _SNOW = 5.0, 2.0
"""Millimeters an hour where the scene has no rate."""
_FOG = 120.0
"""Meters of sight where the scene has none."""
_HOUR = 3_600_000.0
"""Millimeters an hour in a meter per second."""


def put_environment(parent: Element, world: Mapping[str, Any]) -> None:
    """A `GlobalAction` that sets what the scene says; nothing where it says nothing."""
    if not any(world.get(name) is not None for name in _NAMES):
        return
    action = put(put(parent, "GlobalAction"), "EnvironmentAction")
    found = put(action, "Environment", name="world")
    time = world.get("time_of_day")
    if time is not None:
        hours, seconds = divmod(int(time) % 86400, 3600)
        clock = f"{hours:02d}:{seconds // 60:02d}:{seconds % 60:02d}"
        put(found, "TimeOfDay", animation="false", dateTime=f"{_DAY}T{clock}")
    _put_weather(found, world)
    friction = world.get("friction")
    if friction is not None:
        wetness = "moist" if _rain(world) > 0.0 else "dry"
        put(found, "RoadCondition", frictionScaleFactor=float(friction), wetness=wetness)


def _put_weather(parent: Element, world: Mapping[str, Any]) -> None:
    preset, sun = world.get("weather"), world.get("sun") or {}
    visibility = world.get("visibility", _FOG if preset == "fog" else None)
    rain = _rain(world)
    if preset is None and visibility is None and not sun and not rain:
        return
    weather = put(parent, "Weather")
    if preset is not None:
        weather.set("fractionalCloudCover", _OKTAS[preset])
    if sun.get("elevation") is not None:
        azimuth = float(sun.get("azimuth") or 0.0) % math.tau
        put(weather, "Sun", azimuth=azimuth, elevation=float(sun["elevation"]))
    if visibility is not None:
        put(weather, "Fog", visualRange=float(visibility))
    if preset is not None or rain:
        kind = "snow" if preset == "snow" else "rain" if rain else "dry"
        amount = _SNOW if kind == "snow" else rain
        put(weather, "Precipitation", precipitationType=kind, precipitationIntensity=amount)


def _rain(world: Mapping[str, Any]) -> float:
    """Millimeters an hour."""
    rate = world.get("rain")
    if rate is not None:
        return float(rate) * _HOUR
    return _RAIN if world.get("weather") == "rain" else 0.0


_NAMES = ("time_of_day", "weather", "rain", "visibility", "friction", "sun")
