"""The units a number may carry, with exact factors to SI."""

from __future__ import annotations

from dataclasses import dataclass

from ..stl.formats.unit_factors import UNITS as BASE_UNITS
from ..stl.formats.unit_factors import Powers, unit_powers
from ..stl.formats.unit_factors import TwoSlashes as TwoSlashes
from ..stl.formats.unit_factors import UnknownUnit as UnknownUnit
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


def parse_unit(text: str) -> Unit:
    """The unit a number carries: `m`, `m/s^2`, `/m` (as in `0.1/m`) or `1/m`, `m^1.5`.

    Raises `UnknownUnit`, `TwoSlashes`.
    """
    if not text:
        return Unit(1.0, PURE)
    above, below = (_product(powers) for powers in unit_powers(text))
    return Unit(above.factor / below.factor, above.dimension / below.dimension)


def _product(powers: Powers) -> Unit:
    factor, dimension = 1.0, PURE
    for name, exponent in powers:
        factor *= UNITS[name].factor ** exponent
        dimension = dimension * UNITS[name].dimension ** exponent
    return Unit(factor, dimension)
