"""Options that all kinds of objects have."""

from __future__ import annotations

from typing import Any

from roadlang.api import option


def length_option(default: float) -> Any:
    """Dimension along the heading."""
    return option(default, above=0, maximum=500, help="dimension along the heading")


def width_option(default: float) -> Any:
    """Dimension across the heading."""
    return option(default, above=0, maximum=500, help="dimension across the heading")


def height_option(default: float) -> Any:
    """Height above the ground."""
    return option(default, above=0, maximum=500, help="height above the ground")


def color_option(default: str) -> Any:
    """Color by name or code."""
    return option(default, help="color by name or hexadecimal code: `white`, `#2e7d32`")
