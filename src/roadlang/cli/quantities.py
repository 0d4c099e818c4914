"""Options of commands that are times or lengths: `60s`, `1.5min`, or plain numbers in SI units."""

from __future__ import annotations

import re
from typing import Any

import click

from .finite_range import FiniteRange

_WRITTEN = re.compile(r"\s*([-+.0-9eE]*[.0-9])\s*([A-Za-z%][A-Za-z%/]*)?\s*")


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
        if isinstance(value, str):
            number = self._in_si_units(value)
            if number is None:
                instead = f"write a number and a unit, such as {self.example}"
                self.fail(
                    f"{value!r} is not a {self.name}: {instead}. Without a unit it is in "
                    f"{self.unit}.", param, ctx,
                )  # fmt: skip
            value = number
        return super().convert(value, param, ctx)

    def _in_si_units(self, written: str) -> float | None:
        from ..ir.units import TwoSlashes, UnknownUnit, parse_unit

        match = _WRITTEN.fullmatch(written)
        if match is None:
            return None
        try:
            unit, understood = parse_unit(match[2] or self.unit), parse_unit(self.unit)
            number = float(match[1]) * unit.factor
        except (UnknownUnit, TwoSlashes, ValueError):
            return None
        return number if unit.dimension == understood.dimension else None


def seconds(**bounds: Any) -> QuantityRange:
    """A time."""
    return QuantityRange("time", "s", "60s", **bounds)


def meters(**bounds: Any) -> QuantityRange:
    """A length."""
    return QuantityRange("length", "m", "120m", **bounds)


def pixel_size(**bounds: Any) -> QuantityRange:
    """How much ground a pixel shows."""
    return QuantityRange("scale", "m/px", "0.5m/px", **bounds)


def pixels(**bounds: Any) -> QuantityRange:
    """A length in a picture."""
    return QuantityRange("length in pixels", "px", "8px", **bounds)
