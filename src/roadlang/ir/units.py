"""The units a number may carry, with exact factors to SI."""

from __future__ import annotations

import re
from dataclasses import dataclass

from ..stl.formats.unit_factors import UNITS as BASE_UNITS
from .dimension import ANGLE, FORCE, FREQUENCY, LENGTH, MASS, PIXELS, PURE, SPEED, TIME, Dimension


@dataclass(frozen=True, slots=True)
class Unit:
    """`value * factor` is the quantity in SI units."""

    factor: float
    dimension: Dimension


_DIMENSIONS = {
    "length": LENGTH, "pixels": PIXELS, "time": TIME, "angle": ANGLE, "mass": MASS, "force": FORCE,
    "frequency": FREQUENCY, "speed": SPEED, "share": PURE,
}  # fmt: skip
UNITS: dict[str, Unit] = {
    name: Unit(unit.factor, _DIMENSIONS[unit.quantity]) for name, unit in BASE_UNITS.items()
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
