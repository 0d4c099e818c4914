"""Numbers with units, and whether dimensions agree."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from functools import cache

from ...diagnostics import Code, Fix, Label, nearest
from ...ir.dimension import ANGLE, Dimension
from ...ir.units import UNITS, TwoSlashes, Unit, UnknownUnit, parse_unit
from ...ir.values import ConstantValue
from ...plugins.options import Constraints
from ...syntax.tree import nodes as ast
from ...syntax.unit_words import meant_unit
from ..checker import Checker
from ..context import Context
from .expression_types import Quantity, SignalType, TypedExpression, unknown
from .similar_signals import similar_signals

_parse = cache(parse_unit)
_DIGITS = re.compile(r"\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")


def infer_number(checker: Checker, number: ast.NumberLiteral, context: Context) -> TypedExpression:
    """`8m`: the quantity in SI units."""
    value = float(number.digits)
    if not number.unit:
        if value in (float("inf"), float("-inf")):
            return checker.report(Code.NOT_FINITE, number.span, what=f"`{number.digits}`")
        is_integer = value.is_integer()
        kind = Quantity(fits_any=value == 0, bare=True, is_integer=is_integer)
        return TypedExpression(number.span, kind, ConstantValue(value), bounds=(value, value))
    unit = _unit(checker, number)
    if unit is None:
        return unknown(number.span)
    if number.unit.startswith("/") and number.unit[1:].isalpha():
        checker.divisors.append((number.unit[1:], number.span))
    value *= unit.factor
    if value in (float("inf"), float("-inf")):
        return checker.report(Code.NOT_FINITE, number.span, what=f"`{number.digits}{number.unit}`")
    kind = Quantity(unit.dimension, is_integer=unit.dimension.is_pure and value.is_integer())
    return TypedExpression(
        number.span, kind, ConstantValue(value, unit.dimension), bounds=(value, value)
    )


def _unit(checker: Checker, number: ast.NumberLiteral) -> Unit | None:
    try:
        return _parse(number.unit)
    except TwoSlashes:
        better = _as_quotient(number)
        checker.report(
            Code.TWO_SLASHES_IN_UNIT,
            number.span,
            unit=number.unit,
            help=f"write `{better}`",
            fixes=[Fix(number.span, better)],
        )
    except UnknownUnit as error:
        _report_unknown_unit(checker, number, error.word)
    except (OverflowError, ZeroDivisionError):
        checker.report(Code.NOT_FINITE, number.span, what=f"`{number.digits}{number.unit}`")
    return None


def _report_unknown_unit(checker: Checker, number: ast.NumberLiteral, word: str) -> None:
    # `5mtr` looks like `m` and `tr` to a matcher of strings; people mean what they spell out.
    unit = meant_unit(number.unit)
    if unit is None:
        meant = nearest(word, UNITS)
        unit = None if meant is None else number.unit.replace(word, meant, 1)
    if unit is None:
        known = ", ".join(unit for unit in UNITS)
        checker.report(Code.UNKNOWN_UNIT, number.span, unit=word, help=f"the units are {known}")
        return
    better = number.digits + unit
    checker.report(Code.UNKNOWN_UNIT, number.span, unit=word, meant=better)


def _as_quotient(number: ast.NumberLiteral) -> str:
    """`12m/s/s` as `12m/s^2`, and `12m/s/min`, whose divisors differ, as `12m/s / 1min`."""
    above, *below = number.unit.split("/")
    powers = [f"{unit}^{n}" if n > 1 else unit for unit, n in Counter(below).items()]
    return " / 1".join([f"{number.digits}{above}/{powers[0]}", *powers[1:]])


def unit_missing(
    checker: Checker, typed: TypedExpression, expected: Dimension, limits: Constraints | None = None
) -> TypedExpression:
    """RL202: a bare number where a unit is expected, with the number in that unit as fix."""
    common_unit = limits.default_unit if limits is not None else ""
    units = ("deg", "rad") if expected == ANGLE else (common_unit or expected.unit,)
    readings = [_with_unit(typed.span.text, unit) for unit in units]
    such = f", such as `{limits.example}`" if limits is not None and common_unit else ""
    return checker.report(
        Code.MISSING_UNIT,
        typed.span,
        number=typed.span.text,
        expected=f"{expected}{such}",
        help="write " + " or ".join(f"`{reading}`" for reading in readings),
        fixes=[Fix(typed.span, reading) for reading in readings],
    )


def _with_unit(text: str, unit: str) -> str:
    """Each number in `text` with a unit: `10` becomes `10m`, and `0.1` becomes `0.1/m`."""
    attached = unit[1:] if unit.startswith("1/") else unit
    return _DIGITS.sub(lambda match: match[0] + attached, text)


def dimension_of(typed: TypedExpression) -> Dimension:
    """Dimension of a quantity or signal."""
    assert isinstance(typed.type, Quantity | SignalType)
    return typed.type.dimension


def common_dimension(
    checker: Checker, parts: Sequence[TypedExpression], verb: str
) -> Dimension | None:
    """The one dimension of numbers or signals that are added, compared or listed.

    None, reported, where they differ. A bare 0 and `inf` go with everything.
    """
    firm = [part for part in parts if not (isinstance(part.type, Quantity) and part.type.fits_any)]
    if not firm:
        return dimension_of(parts[0])
    with_unit = [part for part in firm if not (isinstance(part.type, Quantity) and part.type.bare)]
    leader = (with_unit or firm)[0]
    expected = dimension_of(leader)
    agreed = True
    for part in firm:
        if dimension_of(part) == expected:
            continue
        agreed = False
        if isinstance(part.type, Quantity) and part.type.bare:
            unit_missing(checker, part, expected)
        else:
            labels = [Label(leader.span, f"{expected}")]
            found = dimension_of(part)
            checker.report(
                Code.DIMENSION_MISMATCH,
                part.span,
                labels=labels,
                verb=verb,
                expected=expected,
                found=found,
                left=short(leader),
                right=short(part),
                help=_mismatch_help(checker, leader, part),
            )
        break
    return expected if agreed else None


def _mismatch_help(
    checker: Checker, left: TypedExpression, right: TypedExpression
) -> tuple[str, ...]:
    """The units of two things, and signals of similar names that have the unit of the other."""
    units = [(short(part), dimension_of(part).unit) for part in (left, right)]
    texts = [f"`{text}` {f'is in {unit}' if unit else 'has no unit'}" for text, unit in units]
    similar = (
        *similar_signals(checker, left, right, dimension_of(right)),
        *similar_signals(checker, right, left, dimension_of(left)),
    )
    return (" and ".join(texts), *similar)


def short(typed: TypedExpression) -> str:
    """The source of an expression, for a message."""
    text = " ".join(typed.span.text.split())
    return text if len(text) <= 40 else text[:37] + "..."
