"""Interval arithmetic: the least and the greatest number that a term can be.

The ends of an interval are floats, or arrays with one number for each variant; this module imports
numpy for arrays only, as `roadlang check` must not. An infinite end stands for "no bound known", so
0 times an infinite end is 0. Ends are computed by the operations that compute the values, which are
monotonic in floating point too: no value is beyond its bounds by rounding.

Source: Moore, Kearfott, Cloud, Introduction to Interval Analysis (2009), chapters 2 and 5.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import reduce
from typing import Any, TypeAlias

from ..formula import terms as t

End: TypeAlias = Any
"""A float, or an array with one number for each variant"""
Bounds: TypeAlias = tuple[End, End]
"""Least and greatest"""

UNKNOWN: Bounds = (-math.inf, math.inf)


def term_bounds(term: t.Term, variables: Mapping[str, Bounds]) -> Bounds:
    """Bounds of a term; nothing is known of a variable that is not among `variables`."""
    known: dict[int, Bounds] = {}

    def of(part: t.Term) -> Bounds:
        # By identity: terms share parts, and equality would look at a shared part again and again.
        if id(part) not in known:
            known[id(part)] = compute(part)
        return known[id(part)]

    def compute(part: t.Term) -> Bounds:
        match part:
            case t.Constant(value):
                return value, value
            case t.Variable(name):
                return variables.get(name, UNKNOWN)
            case t.Negate(operand):
                return negated(of(operand))
            case t.Arithmetic("*", left, right) if left == right:
                return square(of(left))
            case t.Arithmetic(operator, left, right):
                return arithmetic(operator, of(left), of(right))
            case t.Apply(function, arguments):
                return of_function(function, [of(argument) for argument in arguments])
        raise TypeError(f"not a term: {part!r}")

    return of(term)


def of_function(function: str, arguments: Sequence[Bounds]) -> Bounds:
    """Bounds of `abs`, `min` or `max` of arguments within these bounds."""
    if function == "abs":
        return absolute(arguments[0])
    extreme = _least if function == "min" else _greatest
    lows, highs = zip(*arguments, strict=True)
    return extreme(*lows), extreme(*highs)


def arithmetic(operator: str, a: Bounds, b: Bounds) -> Bounds:
    """Bounds of `x operator y`, one of `+ - * / ^`, for x within `a` and y within `b`."""
    if operator == "+":
        return _sum(a[0], b[0], -math.inf), _sum(a[1], b[1], math.inf)
    if operator == "-":
        return arithmetic("+", a, negated(b))
    if operator == "*":
        return _around([_product(x, y) for x in a for y in b])
    if operator == "/":
        return _unless(_contains_zero(b), _around([_quotient(x, y) for x in a for y in b]))
    return _power(a, b)


def negated(a: Bounds) -> Bounds:
    """Bounds of -x."""
    return -a[1], -a[0]


def absolute(a: Bounds) -> Bounds:
    """Bounds of |x|."""
    low, high = abs(a[0]), abs(a[1])
    return _where(_contains_zero(a), 0.0, _least(low, high)), _greatest(low, high)


def square(a: Bounds) -> Bounds:
    """Bounds of x * x."""
    low, high = absolute(a)
    return low * low, high * high


def hull(parts: Sequence[Bounds]) -> Bounds:
    """The least bounds that hold all parts; of none, nothing is known."""
    if not parts:
        return UNKNOWN
    lows, highs = zip(*parts, strict=True)
    return _least(*lows), _greatest(*highs)


def _power(a: Bounds, b: Bounds) -> Bounds:
    """Powers with a constant exponent, of a base that no part of is undefined for."""
    exponent = b[0]
    if not (isinstance(exponent, float | int) and exponent == b[1] and math.isfinite(exponent)):
        return UNKNOWN
    is_integer, negative = float(exponent).is_integer(), exponent < 0
    undefined = _contains_zero(a) if negative else False
    if not is_integer:
        undefined = undefined | (a[0] < 0)
    low, high = (_raised(_where(undefined, 1.0, end), exponent) for end in a)
    found = _least(low, high), _greatest(low, high)
    if is_integer and not negative and exponent % 2 == 0 and exponent > 0:
        found = _where(_contains_zero(a), 0.0, found[0]), found[1]
    return _unless(undefined, found)


def _raised(base: End, exponent: float) -> End:
    if isinstance(base, float | int):
        try:
            return float(base**exponent)
        except OverflowError:
            return math.inf if base > 0 or exponent % 2 == 0 else -math.inf
    import numpy as np

    with np.errstate(all="ignore"):
        return np.power(base, exponent)


def _sum(x: End, y: End, unbounded: float) -> End:
    total = x + y
    return _where(total == total, total, unbounded)  # inf - inf is not a number


def _product(x: End, y: End) -> End:
    zero = (x == 0) | (y == 0)
    return _where(zero, 0.0, _where(zero, 1.0, x) * y)


def _quotient(x: End, y: End) -> End:
    """x / y; 0 where y is infinite or 0, which the caller sorts out."""
    defined = (y != 0) & (abs(y) != math.inf)
    divisor = _where(defined, y, 1.0)
    if isinstance(x, float | int) and isinstance(divisor, float | int):
        return x / divisor if defined else 0.0
    import numpy as np

    with np.errstate(over="ignore", invalid="ignore"):
        return np.where(defined, np.divide(x, divisor), 0.0)


def _contains_zero(a: Bounds) -> Any:
    return (a[0] <= 0) & (a[1] >= 0)


def _around(ends: Sequence[End]) -> Bounds:
    return _least(*ends), _greatest(*ends)


def _unless(condition: Any, known: Bounds) -> Bounds:
    """`known`; where `condition` is true, nothing is known."""
    return _where(condition, -math.inf, known[0]), _where(condition, math.inf, known[1])


def _where(condition: Any, true: End, false: End) -> End:
    if isinstance(condition, bool):
        return true if condition else false
    import numpy as np

    return np.where(condition, true, false)


def _least(*ends: End) -> End:
    if all(isinstance(end, float | int) for end in ends):
        return min(ends)
    import numpy as np

    return reduce(np.minimum, ends)


def _greatest(*ends: End) -> End:
    if all(isinstance(end, float | int) for end in ends):
        return max(ends)
    import numpy as np

    return reduce(np.maximum, ends)
