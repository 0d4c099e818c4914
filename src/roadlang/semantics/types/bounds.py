"""Interval arithmetic: the least and greatest number that an expression can be."""

from __future__ import annotations

import math
from typing import TypeAlias

Bounds: TypeAlias = tuple[float, float]


def negated(a: Bounds | None) -> Bounds | None:
    """Bounds of `-a`."""
    return None if a is None else (-a[1], -a[0])


def absolute(a: Bounds | None) -> Bounds:
    """Never below zero, whatever is known of `a`."""
    if a is None:
        return (0.0, math.inf)
    if a[0] >= 0:
        return a
    if a[1] <= 0:
        return (-a[1], -a[0])
    return (0.0, max(-a[0], a[1]))


def arithmetic(operator: str, a: Bounds | None, b: Bounds | None) -> Bounds | None:
    """Bounds of `a operator b`; None where nothing is known."""
    if a is None or b is None:
        return None
    if operator == "+":
        return _clean((a[0] + b[0], a[1] + b[1]))
    if operator == "-":
        return _clean((a[0] - b[1], a[1] - b[0]))
    if operator == "*":
        return _hull(x * y for x in a for y in b)
    if operator == "/":
        return None if b[0] <= 0 <= b[1] else _hull(x / y for x in a for y in b)
    return _power(a, b)


def least(parts: list[Bounds | None]) -> Bounds | None:
    """Bounds of `min`: below the lowest upper end that is known."""
    known = [part for part in parts if part is not None]
    if not known:
        return None
    low = min(part[0] for part in known) if len(known) == len(parts) else -math.inf
    return (low, min(part[1] for part in known))


def greatest(parts: list[Bounds | None]) -> Bounds | None:
    """Bounds of `max`."""
    return negated(least([negated(part) for part in parts]))


def hull(parts: list[Bounds | None]) -> Bounds | None:
    """The bounds that hold all parts; None where one is not known."""
    known = [part for part in parts if part is not None]
    if len(known) < len(parts) or not known:
        return None
    return (min(part[0] for part in known), max(part[1] for part in known))


def _power(a: Bounds, b: Bounds) -> Bounds | None:
    if b[0] != b[1] or (a[0] < 0 and not (a[0] == a[1] and b[0].is_integer())):
        return None
    try:
        return _hull(x ** b[0] for x in a)
    except (OverflowError, ZeroDivisionError):
        return None


def _hull(values: object) -> Bounds | None:
    found = list(values)  # type: ignore[call-overload]
    return _clean((min(found), max(found)))


def _clean(bounds: Bounds) -> Bounds | None:
    return None if math.isnan(bounds[0]) or math.isnan(bounds[1]) else bounds
