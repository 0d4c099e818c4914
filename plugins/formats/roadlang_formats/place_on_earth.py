"""Where on Earth (0, 0) of a scene is: said by its map, or by the option `origin`."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from roadlang.api import OptionError

if TYPE_CHECKING:
    from roadlang.api import Scene

Degrees = tuple[float, float]
"""Latitude and longitude."""


def stated_origin(origin: tuple[float, float] | None) -> Degrees | None:
    """The option `origin`, latitude and longitude in radians, in degrees.

    Raises OptionError for an origin that is not on Earth.
    """
    if origin is None:
        return None
    latitude, longitude = math.degrees(origin[0]), math.degrees(origin[1])
    if abs(latitude) > 90.0:
        raise OptionError("origin", f"has the latitude {latitude:g}deg; the poles are at 90deg",
            "it is written `(latitude, longitude)`")  # fmt: skip
    if abs(longitude) > 180.0:
        raise OptionError("origin", f"has the longitude {longitude:g}deg, beyond 180deg")
    return latitude, longitude


def map_origin(scene: Scene) -> Degrees | None:
    """The origin of the first map of the scene that has one."""
    found = (network.origin for network in scene.networks)
    return next((origin for origin in found if origin is not None), None)
