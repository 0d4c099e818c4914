"""Options of commands that are times or lengths: `60s`, `1.5min`, or plain numbers in SI units."""

from __future__ import annotations

import re
from typing import Any, NoReturn

import click

from ..syntax.units import UNITS
from .finite_range import FiniteRange

_WRITTEN = re.compile(r"\s*(?P<digits>[-+.0-9eE]*[.0-9])\s*(?P<unit>[A-Za-z%]+(?:/[A-Za-z]+)?)\s*")


class QuantityRange(FiniteRange):
    """A number between bounds, with the unit that is understood without one (`s`, `m/px`) or with
    another of the same kind."""

    def __init__(self, name: str, unit: str, example: str, **bounds: Any) -> None:
        super().__init__(**bounds)
        self.name = name
        self.unit = unit
        self.example = example

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> float:
        """The number, in SI units. Raises `click.BadParameter`."""
        written = _WRITTEN.fullmatch(value) if isinstance(value, str) else None
        if written is None:
            if isinstance(value, str) and not _is_number(value):
                self._refuse(value, param, ctx)
            return super().convert(value, param, ctx)
        factor = _factor(written["unit"], self.unit)
        if factor is None or not _is_number(written["digits"]):
            self._refuse(value, param, ctx)
        return super().convert(float(written["digits"]) * factor, param, ctx)

    def _refuse(self, value: str, param: Any, ctx: Any) -> NoReturn:
        fault = f"{value!r} is not a {self.name}: write a number and a unit, such as {self.example}"
        self.fail(f"{fault}. Without a unit it is in {self.unit}.", param, ctx)


def seconds(**bounds: Any) -> QuantityRange:
    """A time."""
    return QuantityRange("time", "s", "60s", **bounds)


def pixel_size(**bounds: Any) -> QuantityRange:
    """How much ground a pixel shows."""
    return QuantityRange("scale", "m/px", "0.5m/px", **bounds)


def pixels(**bounds: Any) -> QuantityRange:
    """A length in a picture."""
    return QuantityRange("length in pixels", "px", "8px", **bounds)


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _factor(unit: str, understood: str) -> float | None:
    """From one unit to the other; None where they measure different things."""
    parts, wanted = unit.split("/"), understood.split("/")
    if len(parts) != len(wanted) or not all(part in UNITS for part in parts):
        return None
    for part, want in zip(parts, wanted, strict=True):
        if UNITS[part].quantity != UNITS[want].quantity:
            return None
    above, *below = (UNITS[part].factor for part in parts)
    return above / below[0] if below else above
