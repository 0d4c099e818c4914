"""Speed limits in the units of OpenDRIVE."""

from __future__ import annotations

from roadlang_formats.map_xml import MapElement, MapFile
from roadlang_formats.speed_units import KMH, MPH

_UNITS = {"m/s": 1.0, "km/h": KMH, "mph": MPH}
_FASTEST = 200.0
"""m/s; higher values count as no limit."""


def speed_of(file: MapFile, element: MapElement | None) -> float | None:
    """The limit of a `speed` element in m/s; None where it sets none."""
    if element is None or element.attributes.get("max") in (None, "no limit", "undefined"):
        return None
    unit = element.attributes.get("unit", "m/s")
    if unit not in _UNITS:
        raise file.fault(
            element, f"the unit of a speed must be one of {', '.join(_UNITS)}, not `{unit}`"
        )
    found = file.number(element, "max") * _UNITS[unit]
    return found if 0.0 < found < _FASTEST else None
