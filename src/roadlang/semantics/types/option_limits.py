"""Whether a number keeps the limits of its option, in every scene as far as is known."""

from __future__ import annotations

import math
import re

from ...diagnostics import Code, Fix
from ...ir.dimension import Dimension
from ...plugins.describing import value_text
from ...plugins.option_types import QuantityType
from ...plugins.options import Constraints
from ..checker import Checker
from .expression_types import TypedExpression

_SUBTRACTION = re.compile(r"(\d[\w.%/^]*)\s*-\s*(\d[\w.%/^]*)")


def check_limits(
    checker: Checker, typed: TypedExpression, limits: Constraints, what: str, dimension: Dimension
) -> bool:
    """False, reported, where the number can be beyond a limit."""
    low, high = typed.bounds
    if math.isinf(low) and math.isinf(high) and low != high:
        return True
    low, high = _finite_ends(low, high)
    fault = _below(limits, low) or _above(limits, high)
    if fault is None:
        return True
    word, limit, number = fault
    meant = subtraction_as_range(typed.span.text)
    verb = "can be" if low != high else "is"
    advice = f"to draw a value between the two, write `{meant}`" if meant else ""
    if not advice and high < 0.0:
        advice = limits.if_negative
    checker.report(
        Code.VALUE_OUT_OF_BOUNDS,
        typed.span,
        what=what,
        expected=f"be {word} {_quantity(limit, dimension)}",
        found=f"{verb} {_quantity(number, dimension)}",
        help=advice or _advice(limits, dimension, is_drawn=low != high),
        fixes=[Fix(typed.span, meant)] if meant else (),
    )
    return False


def _advice(limits: Constraints, dimension: Dimension, is_drawn: bool) -> str:
    """What may be written instead: `write a value from 1 to 32`, `... of more than 0s`."""
    least = limits.minimum if limits.minimum is not None else limits.above
    most = limits.maximum if limits.maximum is not None else limits.below
    low, high = (None if end is None else _quantity(end, dimension) for end in (least, most))
    ends = [f"more than `{low}`" if limits.minimum is None else f"at least `{low}`"] if low else []
    if high:
        ends.append(f"less than `{high}`" if limits.maximum is None else f"at most `{high}`")
    allowed = f"of {' and '.join(ends)}"
    if limits.minimum is not None and limits.maximum is not None:
        allowed = f"from `{low}` to `{high}`"
    drawn = "every value that can be drawn must be allowed: " if is_drawn else ""
    return f"{drawn}write a value {allowed}"


def subtraction_as_range(text: str) -> str | None:
    """`0.4-0.9` as the range that may be meant; None for anything but two plain numbers."""
    match = _SUBTRACTION.fullmatch(text)
    return f"{match[1]}..{match[2]}" if match else None


def _finite_ends(low: float, high: float) -> tuple[float, float]:
    """The two ends; the other one for an infinite end, of which nothing is known."""
    if low == high:  # `inf` as written
        return low, high
    return (high if math.isinf(low) else low), (low if math.isinf(high) else high)


def _below(limits: Constraints, low: float) -> tuple[str, float, float] | None:
    if limits.minimum is not None and limits.least is not None and low < limits.least:
        return "at least", limits.minimum, low
    if limits.above is not None and low <= limits.above:
        return "greater than", limits.above, low
    return None


def _above(limits: Constraints, high: float) -> tuple[str, float, float] | None:
    if limits.maximum is not None and limits.most is not None and high > limits.most:
        return "at most", limits.maximum, high
    if limits.below is not None and high >= limits.below:
        return "less than", limits.below, high
    return None


def _quantity(value: float, dimension: Dimension) -> str:
    return value_text(value, QuantityType(dimension))
