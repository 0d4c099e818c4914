"""Factors to SI of the units that a formula in the library may carry.

A formula of the library has no dimensions to check, only numbers to convert; the compiler checks
them (`roadlang.ir.units`).
"""

from __future__ import annotations

from ...diagnostics import Fix, did_you_mean
from ...syntax.tree import nodes as ast
from ...syntax.unit_words import meant_unit
from ...syntax.units import UNITS as UNITS
from ...syntax.units import Powers as Powers
from ...syntax.units import TwoSlashes as TwoSlashes
from ...syntax.units import UnknownUnit as UnknownUnit
from ...syntax.units import unit_powers as unit_powers


def known_units() -> tuple[str, ...]:
    """The units from which others are built with `*`, `/` and `^`."""
    return tuple(UNITS)


def factor(unit: str) -> float:
    """SI units in one `unit`: 1000 for `km`, 1/3.6 for `km/h`. Raises KeyError for others."""
    try:
        above, below = unit_powers(unit)
    except (UnknownUnit, TwoSlashes):
        raise KeyError(unit) from None
    return _product(above) / _product(below)


def is_unit(unit: str) -> bool:
    """Whether `factor` knows this unit."""
    try:
        factor(unit)
    except KeyError:
        return False
    return True


def axis_of(unit: str) -> str | None:
    """What positions an interval in this unit spans: "length", "time", or neither."""
    quantity = UNITS[unit].quantity if unit in UNITS else None
    return quantity if quantity in ("length", "time") else None


def unit_help(node: ast.NumberLiteral) -> tuple[tuple[str, ...], tuple[Fix, ...]]:
    """Lines of help, and fixes, for a unit that is none; in `1/x` it is a division."""
    above, slash, below = node.unit.rpartition("/")
    if slash and below.isidentifier() and (not above or is_unit(above)):
        meant = f"{node.digits}{above} / {below}"
        return (f"to divide by a signal, put spaces around `/`: `{meant}`",), (
            Fix(node.span, meant),
        )
    spelled_out = meant_unit(node.unit)
    if spelled_out is not None:
        meant = node.digits + spelled_out
        return (f"did you mean `{meant}`?",), (Fix(node.span, meant),)
    hints = (
        *did_you_mean(node.unit, known_units()),
        f"leave the unit away (`{node.digits}`), or use one such as m, km, s, ms, km/h",
    )
    return hints, (Fix(node.span, node.digits),)


def _product(powers: Powers) -> float:
    result = 1.0
    for name, exponent in powers:
        result *= UNITS[name].factor ** exponent
    return result
