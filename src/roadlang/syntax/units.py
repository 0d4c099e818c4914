"""The units that a number may carry: the factor to SI and what they measure. One table for all."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
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

_POWER = re.compile(r"([A-Za-z%]+)(?:\^(-?[0-9]+(?:\.[0-9]+)?))?\Z")


class UnknownUnit(ValueError):
    """Not a unit; `word` is the part that is not known."""

    def __init__(self, word: str) -> None:
        super().__init__(word)
        self.word = word


class TwoSlashes(ValueError):
    """A unit has one `/` at most: `m/s^2`, not `m/s/s`."""


Powers = tuple[tuple[str, float], ...]


def unit_powers(text: str) -> tuple[Powers, Powers]:
    """The names in `UNITS` above and below the `/` of a unit, with their exponents: of `m/s^2`,
    `m` to the 1 and `s` to the 2. Nothing is above in `/m` (as in `0.1/m`) and `1/m`.

    Raises `UnknownUnit`, `TwoSlashes`.
    """
    above, *below = text.split("/")
    if len(below) > 1:
        raise TwoSlashes(text)
    first = () if above in ("", "1") else tuple(_powers(above))
    return first, tuple(_powers(below[0])) if below else ()


def _powers(product: str) -> Iterator[tuple[str, float]]:
    for part in product.split("*"):
        match = _POWER.match(part)
        if match is None or match[1] not in UNITS:
            raise UnknownUnit(match[1] if match else part)
        yield match[1], float(match[2] or 1)
