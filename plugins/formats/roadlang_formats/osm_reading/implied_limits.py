"""The speed limits that OpenStreetMap writes as words: `DE:urban`, `GB:nsl_single`, `walk`."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Final

from ..speed_units import KMH, MPH

_WALKING: Final = 7
"""Walking pace, in km/h, as German courts read it. The law of most countries has no number."""

# km/h within towns, outside of them, on roads for motor vehicles only, and on motorways, in the
# order of _CONTEXTS; 0: there is no such limit, or it is not the same everywhere in the country.
_CONTEXTS: Final = ("urban", "rural", "trunk", "motorway")
_NATIONAL: Final[Mapping[str, tuple[int, int, int, int]]] = {
    "AR": (40, 110, 120, 130),
    "AT": (50, 100, 100, 130),
    "AU": (50, 100, 0, 0),
    "BE": (50, 0, 120, 120),
    "BG": (50, 90, 120, 140),
    "BY": (60, 90, 0, 110),
    "CH": (50, 80, 100, 120),
    "CZ": (50, 90, 110, 130),
    "DE": (50, 100, 0, 0),
    "DK": (50, 80, 80, 130),
    "EE": (50, 90, 0, 0),
    "ES": (30, 90, 0, 120),
    "FI": (50, 80, 100, 120),
    "FR": (50, 80, 110, 130),
    "GR": (50, 90, 110, 130),
    "HR": (50, 90, 110, 130),
    "HU": (50, 90, 110, 130),
    "IE": (50, 80, 100, 120),
    "IL": (50, 80, 90, 110),
    "IS": (50, 90, 0, 0),
    "IT": (50, 90, 110, 130),
    "LT": (50, 90, 120, 130),
    "LU": (50, 90, 0, 130),
    "LV": (50, 90, 110, 0),
    "NL": (50, 80, 100, 130),
    "NO": (50, 80, 0, 110),
    "NZ": (50, 100, 0, 0),
    "PL": (50, 90, 120, 140),
    "PT": (50, 90, 100, 120),
    "RO": (50, 90, 100, 130),
    "RS": (50, 80, 100, 120),
    "RU": (60, 90, 0, 110),
    "SE": (50, 70, 0, 110),
    "SI": (50, 90, 110, 130),
    "SK": (50, 90, 130, 130),
    "TR": (50, 90, 110, 120),
    "UA": (50, 90, 110, 130),
    "ZA": (60, 100, 0, 120),
}
_LIVING_STREETS: Final[Mapping[int, str]] = {
    20: "BE BG BY CH CZ EE ES FI FR HU LT LU LV PL PT RO RU SK UA",
    15: "DK NL",
    10: "AU IS NZ RS SI",
    _WALKING: "AT DE HR NO SE",
}
"""The countries of each limit, in km/h."""
_BRITISH: Final[Mapping[str, int]] = {
    "urban": 30,
    "nsl_restricted": 30,
    "rural": 60,
    "nsl_single": 60,
    "nsl_dual": 70,
    "motorway": 70,
}
"""mph."""


def implied_limit(written: str) -> float | None:
    """The limit, in m/s, of a word for one: `walk`, or a country and a context or zone.

    None where there is no limit (`none`, `DE:motorway`), where it changes (`signals`), and for
    words and countries that are not known here.
    """
    if written in ("walk", "walking"):
        return _WALKING * KMH
    found = re.fullmatch(r"([A-Za-z]{2}):([a-z_]+|(?:zone:?)?(\d{1,3}))", written)
    if found is None:
        return None
    country, context, zone = found.group(1).upper(), found.group(2), found.group(3)
    if country in ("GB", "UK"):
        return (int(zone) if zone else _BRITISH.get(context, 0)) * MPH or None
    return (int(zone) if zone else _national(country, context)) * KMH or None


def _national(country: str, context: str) -> int:
    if context in _CONTEXTS and country in _NATIONAL:
        return _NATIONAL[country][_CONTEXTS.index(context)]
    if context == "living_street":
        return next((limit for limit, of in _LIVING_STREETS.items() if country in of.split()), 0)
    return 0
