"""Numbers as people read them: few digits, with units."""

from __future__ import annotations

import math
import re

_MINUS, _SPACE = "\N{MINUS SIGN}", "\N{NO-BREAK SPACE}"
_COMMA = re.compile(r"(?<=\d),(?=\d)")


def number(value: float, digits: int = 3) -> str:
    """`digits` significant digits, without zeros at the end; counts have commas."""
    if not math.isfinite(value):
        return "\N{INFINITY}" if value > 0 else f"{_MINUS}\N{INFINITY}"
    if abs(value) >= 10**digits:
        text = f"{value:,.0f}"
    elif value and abs(value) < 1e-4:
        text = f"{value:.{digits - 1}e}"
    else:
        text = f"{value:.{digits}g}"
    return text.replace("-", _MINUS)


def quantity(value: float | None, unit: str = "", digits: int = 3) -> str:
    """A number with its unit; angles in degrees. A dash where there is none."""
    if value is None:
        return "\N{EN DASH}"
    scaled, shown = shown_unit(unit)
    return number(value * scaled, digits) + (f"{_SPACE}{shown}" if shown else "")


def plain(text: str) -> str:
    """Numbers as terminals have them, to copy into files: with the signs that keyboards have, and
    without commas in large ones."""
    text = _COMMA.sub("", text)
    return text.replace(_MINUS, "-").replace(_SPACE, " ").replace("\N{INFINITY}", "inf")


def shown_unit(unit: str) -> tuple[float, str]:
    """The unit in which people read what is in this SI unit, and the factor."""
    if unit == "rad":
        return 180.0 / math.pi, "deg"
    return 1.0, unit.replace("^2", "\N{SUPERSCRIPT TWO}").replace("^3", "\N{SUPERSCRIPT THREE}")


def percent(share: float) -> str:
    """A share in percent, with three significant digits."""
    return f"{number(100.0 * share)}%"
