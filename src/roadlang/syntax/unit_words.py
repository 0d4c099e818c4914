"""Units as people spell them out: `meters`, `km per hour`, `kph`. One table for all."""

from __future__ import annotations

import re

from .units import UNITS

_SYMBOLS = {
    "meter": "m", "metre": "m", "mtr": "m", "millimeter": "mm", "millimetre": "mm",
    "centimeter": "cm", "centimetre": "cm", "kilometer": "km", "kilometre": "km",
    "foot": "ft", "feet": "ft", "mile": "mi", "pixel": "px",
    "sec": "s", "second": "s", "msec": "ms", "millisecond": "ms", "minute": "min", "hour": "h",
    "hr": "h", "radian": "rad", "degree": "deg", "percent": "%",
    "\N{DEGREE SIGN}": "deg", "\N{MASCULINE ORDINAL INDICATOR}": "deg",
    "kilogram": "kg", "tonne": "t", "newton": "N", "hertz": "Hz",
    "kmh": "km/h", "kph": "km/h", "kmph": "km/h", "mps": "m/s",
}  # fmt: skip
_BY_LOWER_CASE = {unit.lower(): unit for unit in UNITS}
_PARTS = re.compile(r"([/*]|[ \t]+per[ \t]+)")
_POWER = re.compile(r"(.+?)(\^-?\d+(?:\.\d+)?)?\Z")
_WORD = r"(?:[^\W\d_]+|\N{DEGREE SIGN})(?:\^-?\d+(?:\.\d+)?)?"
SPELLED_UNIT = re.compile(rf"{_WORD}(?:(?:/|[ \t]+per[ \t]+){_WORD})*")
"""Words that may be a unit, such as `km/h`, `meters` and `kilometers per hour`."""


def meant_unit(text: str) -> str | None:
    """The unit that the words mean: `m/s` for `meters per second`; None where one is unknown."""
    parts = [_symbol_or_sign(part) for part in _PARTS.split(text)]
    return None if None in parts else "".join(map(str, parts))


def _symbol_or_sign(part: str) -> str | None:
    if part.strip() in ("/", "*", "per"):
        return "*" if part == "*" else "/"
    match = _POWER.match(part)
    if match is None:
        return None if part else ""
    word, power = match[1], match[2] or ""
    lower = word.lower()
    symbol = word if word in UNITS else _SYMBOLS.get(lower) or _SYMBOLS.get(lower.removesuffix("s"))
    symbol = symbol or _BY_LOWER_CASE.get(lower)
    return None if symbol is None else symbol + power
