"""The units a number may carry, with exact factors to SI."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from .dimension import ANGLE, FORCE, FREQUENCY, LENGTH, MASS, PIXELS, PURE, SPEED, TIME, Dimension


@dataclass(frozen=True, slots=True)
class Unit:
    """`value * factor` is the quantity in SI units."""

    factor: float
    dimension: Dimension


UNITS: dict[str, Unit] = {
    "m": Unit(1.0, LENGTH),
    "mm": Unit(1e-3, LENGTH),
    "cm": Unit(1e-2, LENGTH),
    "km": Unit(1e3, LENGTH),
    "ft": Unit(0.3048, LENGTH),
    "mi": Unit(1609.344, LENGTH),
    "px": Unit(1.0, PIXELS),
    "s": Unit(1.0, TIME),
    "ms": Unit(1e-3, TIME),
    "min": Unit(60.0, TIME),
    "h": Unit(3600.0, TIME),
    "rad": Unit(1.0, ANGLE),
    "deg": Unit(math.pi / 180, ANGLE),
    "kg": Unit(1.0, MASS),
    "t": Unit(1e3, MASS),
    "N": Unit(1.0, FORCE),
    "Hz": Unit(1.0, FREQUENCY),
    "mph": Unit(1609.344 / 3600, SPEED),
    "%": Unit(1e-2, PURE),
}

_PART = re.compile(r"([A-Za-z%]+)(?:\^(-?[0-9]+(?:\.[0-9]+)?))?\Z")


class UnknownUnit(ValueError):
    """Not a unit; `word` is the part that is not known."""

    def __init__(self, word: str) -> None:
        super().__init__(word)
        self.word = word


class TwoSlashes(ValueError):
    """A unit has one `/` at most: `m/s^2`, not `m/s/s`."""


def parse_unit(text: str) -> Unit:
    """The unit a number carries: `m`, `m/s^2`, `/m` (as in `0.1/m`) or `1/m`, `m^1.5`.

    Raises `UnknownUnit`, `TwoSlashes`.
    """
    if not text:
        return Unit(1.0, PURE)
    above, *below = text.split("/")
    if len(below) > 1:
        raise TwoSlashes(text)
    unit = _product(above) if above not in ("", "1") else Unit(1.0, PURE)
    if below:
        divisor = _product(below[0])
        unit = Unit(unit.factor / divisor.factor, unit.dimension / divisor.dimension)
    return unit


def _product(text: str) -> Unit:
    factor, dimension = 1.0, PURE
    for part in text.split("*"):
        match = _PART.match(part)
        if match is None or match[1] not in UNITS:
            raise UnknownUnit(match[1] if match else part)
        exponent = float(match[2]) if match[2] else 1.0
        factor *= UNITS[match[1]].factor ** exponent
        dimension = dimension * UNITS[match[1]].dimension ** exponent
    return Unit(factor, dimension)
