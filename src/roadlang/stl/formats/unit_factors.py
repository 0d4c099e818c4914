"""Factors to SI of the units that a formula in the library may carry.

A formula of the library has no dimensions to check, only numbers to convert; the compiler has
its own table with dimensions (`roadlang.ir.units`), and a test keeps the two alike.
"""

from __future__ import annotations

import math
import re

_FACTORS = {
    "m": 1.0, "mm": 1e-3, "cm": 1e-2, "km": 1e3, "ft": 0.3048, "mi": 1609.344, "px": 1.0,
    "s": 1.0, "ms": 1e-3, "min": 60.0, "h": 3600.0, "rad": 1.0, "deg": math.pi / 180,
    "kg": 1.0, "t": 1e3, "N": 1.0, "Hz": 1.0, "mph": 1609.344 / 3600, "%": 1e-2,
}  # fmt: skip
_LENGTHS = frozenset({"m", "mm", "cm", "km", "ft", "mi"})
_TIMES = frozenset({"s", "ms", "min", "h"})
_PART = re.compile(r"([A-Za-z%]+)(?:\^(-?[0-9]+(?:\.[0-9]+)?))?\Z")


def known_units() -> tuple[str, ...]:
    """The units from which others are built with `*`, `/` and `^`."""
    return tuple(_FACTORS)


def factor(unit: str) -> float:
    """SI units in one `unit`: 1000 for `km`, 1/3.6 for `km/h`. Raises KeyError for others."""
    above, *below = unit.split("/")
    if len(below) > 1:
        raise KeyError(unit)
    return _product(above) / _product(below[0] if below else "")


def axis_of(unit: str) -> str | None:
    """What positions an interval in this unit spans: "length", "time", or neither."""
    return "length" if unit in _LENGTHS else "time" if unit in _TIMES else None


def _product(text: str) -> float:
    result = 1.0
    for part in filter(None, text.split("*")):
        match = _PART.match(part)
        if match is None:
            raise KeyError(part)
        result *= _FACTORS[match[1]] ** float(match[2] or 1)
    return result
