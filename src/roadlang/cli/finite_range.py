"""Numbers as options of commands; what is none is answered with what would be one."""

from __future__ import annotations

import math
from typing import Any

import click

from ..ir.seeds import LARGEST_SEED

_MOST_DIGITS = 40
"""Of a number that is shown."""


class WholeNumber(click.IntRange):
    """A whole number between bounds, written in digits."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> int:
        """The number. Raises `click.BadParameter`."""
        text = str(value).strip()
        if not (text.isascii() and text.removeprefix("-").removeprefix("+").isdigit()):
            meant = f"write one {bounds_text(self)}".rstrip()
            self.fail(f"{value!r} is not a whole number: {meant}.", param, ctx)
        # Of thousands of digits Python makes no number; none of them is in the bounds.
        number = int(text[:_MOST_DIGITS])
        if not is_within(self, number):
            shown = text if len(text) < _MOST_DIGITS else f"{text[:_MOST_DIGITS]}..."
            meant = f"write a whole number {bounds_text(self)}"
            self.fail(f"{shown} is out of range: {meant}.", param, ctx)
        return number


class Seed(WholeNumber):
    """A seed of random numbers."""

    def __init__(self) -> None:
        super().__init__(min=0)  # no `max`: help would show all of its digits

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> int:
        """The seed. Raises `click.BadParameter`."""
        seed = super().convert(value, param, ctx)
        if seed > LARGEST_SEED:
            self.fail(f"a seed is at most {LARGEST_SEED}.", param, ctx)
        return seed


class FiniteNumber(click.types.FloatParamType):
    """A number. `click.FLOAT` takes `nan` and `inf` for one."""

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> float:
        """The number. Raises `click.BadParameter`."""
        try:
            number = math.nan if "_" in str(value) else float(value)
        except ValueError:
            number = math.nan
        if not math.isfinite(number):
            meant = f"write a number {bounds_text(self)}".rstrip()
            self.fail(f"{value!r} is not a finite number: {meant}.", param, ctx)
        return number


class FiniteRange(FiniteNumber, click.FloatRange):
    """A number between bounds."""

    unit: str = ""
    """Of the bounds in messages."""

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> float:
        """The number. Raises `click.BadParameter`."""
        number = FiniteNumber.convert(self, value, param, ctx)
        if not is_within(self, number):
            shown, meant = f"{number:g}{self.unit}", bounds_text(self, self.unit)
            self.fail(f"{shown} is out of range: write a number {meant}.", param, ctx)
        return number


def is_within(bounds: Any, number: float) -> bool:
    """Whether a number is in the range of an option."""
    low, high = bounds.min, bounds.max
    above = low is None or (number > low if bounds.min_open else number >= low)
    return above and (high is None or (number < high if bounds.max_open else number <= high))


def bounds_text(bounds: Any, unit: str = "") -> str:
    """The range of an option in words: `from 1 to 256`, `of at least 0`, `above 0s`."""
    low, high = getattr(bounds, "min", None), getattr(bounds, "max", None)
    if low is None and high is None:
        return ""
    if low is not None and high is not None and not bounds.min_open and not bounds.max_open:
        return f"from {_shown(low)}{unit} to {_shown(high)}{unit}"
    words = []
    if low is not None:
        words.append(f"{'above' if bounds.min_open else 'of at least'} {_shown(low)}{unit}")
    if high is not None:
        words.append(f"{'below' if bounds.max_open else 'of at most'} {_shown(high)}{unit}")
    return " and ".join(words)


def _shown(bound: float) -> str:
    return str(bound) if isinstance(bound, int) else f"{bound:g}"
