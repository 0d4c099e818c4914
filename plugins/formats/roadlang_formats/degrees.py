"""Places on Earth that maps may have: latitude and longitude in degrees."""

from __future__ import annotations

_LARGEST_LATITUDE = 89.0


def why_no_place(latitude: float, longitude: float) -> str:
    """Why no road can be there; "" for all other places."""
    if abs(latitude) <= 90.0 and abs(longitude) <= 180.0:
        if abs(latitude) <= _LARGEST_LATITUDE:
            return ""
        return (
            f"latitude {latitude:g} degrees: roads less than 1 degree from a pole are not supported"
        )
    swapped = abs(longitude) <= 90.0 and abs(latitude) <= 180.0
    order = ": is the longitude in the place of the latitude?" if swapped else ""
    return f"latitude {latitude:g}, longitude {longitude:g} degrees is not a place on Earth{order}"
