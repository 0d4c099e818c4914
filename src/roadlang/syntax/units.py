"""The units that a number may carry: the factor to SI and what they measure. One table for all."""

from __future__ import annotations

import math
from typing import NamedTuple


class BaseUnit(NamedTuple):
    """A number times `factor` is in SI units of the `quantity`."""

    factor: float
    quantity: str


UNITS: dict[str, BaseUnit] = {
    "m": BaseUnit(1.0, "length"),
    "mm": BaseUnit(1e-3, "length"),
    "cm": BaseUnit(1e-2, "length"),
    "km": BaseUnit(1e3, "length"),
    "ft": BaseUnit(0.3048, "length"),
    "mi": BaseUnit(1609.344, "length"),
    "px": BaseUnit(1.0, "pixels"),
    "s": BaseUnit(1.0, "time"),
    "ms": BaseUnit(1e-3, "time"),
    "min": BaseUnit(60.0, "time"),
    "h": BaseUnit(3600.0, "time"),
    "rad": BaseUnit(1.0, "angle"),
    "deg": BaseUnit(math.pi / 180, "angle"),
    "kg": BaseUnit(1.0, "mass"),
    "t": BaseUnit(1e3, "mass"),
    "N": BaseUnit(1.0, "force"),
    "Hz": BaseUnit(1.0, "frequency"),
    "mph": BaseUnit(1609.344 / 3600, "speed"),
    "%": BaseUnit(1e-2, "share"),
}
