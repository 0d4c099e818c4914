"""Options that kinds of agents share: dimensions, mass and color, each with its own default."""

from __future__ import annotations

from typing import Any

from roadlang.api import option


def length_option(default: float) -> Any:
    """Meters along the vehicle."""
    return option(default, above=0, maximum=40, help="length from bumper to bumper")


def width_option(default: float) -> Any:
    """Meters across the vehicle."""
    return option(default, above=0, maximum=10, help="width without mirrors")


def height_option(default: float) -> Any:
    """Meters."""
    return option(default, above=0, maximum=10, help="height above the ground")


def wheelbase_option(default: float) -> Any:
    """Meters."""
    return option(default, above=0, maximum=20, help="distance between the axles")


def max_steering_option(default: float) -> Any:
    """Radians."""
    help = "maximum steering angle of the front wheels, to either side"
    return option(default, above=0, maximum=1.5, help=help)


def mass_option(default: float) -> Any:
    """Kilograms."""
    return option(default, above=0, help="total mass, including driver or rider")


def color_option(default: str) -> Any:
    """By name or in hexadecimal."""
    return option(default, help="color by name or hexadecimal code: `white`, `#1f5fa8`")
