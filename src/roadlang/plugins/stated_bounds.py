"""Bounds that kinds state from their options alone, where these may be ranges.

A stated bound is monotonic in every option, so that the hull of what a kind states at all corners
of the ranges holds for everything between them.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from itertools import count, product
from typing import Any, NamedTuple

from ..diagnostics import DiagnosticError, Span
from .guard import plugin_guard, wrong_result
from .kinds import Kind
from .option_types import QuantityType
from .options import schema_of
from .registry import KindEntry

_MOST_CORNERS = 64
_INNER_POINTS = 16
_GOLDEN = (math.sqrt(5.0) - 1.0) / 2.0
"""Multiples of it modulo 1 are spread evenly over 0 to 1."""


class OptionRange(NamedTuple):
    """Least and greatest value of a number in an option."""

    low: float
    high: float


def stated_support(
    entry: KindEntry, kind: type[Kind], options: Mapping[str, Any], span: Span | None
) -> OptionRange:
    """Least and greatest value that a distribution states; of constant options as it states them,
    in reverse where they are. Raises RL474 for what is no range."""
    combinations = corners(kind, options)
    if combinations is None:
        return OptionRange(-math.inf, math.inf)
    stated: list[OptionRange] = []
    for fields in combinations:
        try:
            with plugin_guard(entry, span):
                instance = kind(**fields)
        except DiagnosticError:  # a corner that is never drawn, as `low` above `high`
            return OptionRange(-math.inf, math.inf)
        stated.append(_support(instance, entry, span))
    if len(stated) == 1:
        return stated[0]
    ends = [end for found in stated for end in found]
    return OptionRange(min(ends), max(ends))


def _support(instance: Any, entry: KindEntry, span: Span | None) -> OptionRange:
    with plugin_guard(entry, span):
        support = instance.support()
        if support is None:
            return OptionRange(-math.inf, math.inf)
        low, high = map(float, support)
    if math.isnan(low) or math.isnan(high):
        raise wrong_result(entry, span, f"gave the support ({low:g}, {high:g})")
    return OptionRange(low, high)


def corners(kind: type[Kind], options: Mapping[str, Any]) -> list[dict[str, Any]] | None:
    """Every combination of the ends of options that are an `OptionRange`; other values as they are.

    None where an end is not known, or where there are too many.
    """
    combinations = _ends(tuple(options.values()))
    return None if combinations is None else _rows(kind, options, combinations)


def inner_points(kind: type[Kind], options: Mapping[str, Any]) -> list[dict[str, Any]]:
    """The middle of all options that are an `OptionRange`, whose ends are finite, and other points
    between the ends, each at another share of every range."""
    inside = [
        _inside(tuple(options.values()), ((0.5 + point * i * _GOLDEN) % 1.0 for i in count(1)))
        for point in range(_INNER_POINTS)
    ]
    return _rows(kind, options, inside)


def _rows(
    kind: type[Kind], options: Mapping[str, Any], combinations: Iterable[Iterable[Any]]
) -> list[dict[str, Any]]:
    """Options by name, for each combination of their values; integers as such."""
    integers = {option.name for option in schema_of(kind) if _is_integer(option.type)}
    rows = (dict(zip(options, combination, strict=True)) for combination in combinations)
    return [{key: _whole(v) if key in integers else v for key, v in row.items()} for row in rows]


def _whole(value: Any) -> Any:
    """A number as an integer; a word that an option takes in place of one as it is."""
    return round(value) if isinstance(value, int | float) else value


def _inside(value: Any, shares: Iterator[float]) -> Any:
    """The value of an option between its ends, each range at the next of `shares` of it."""
    if isinstance(value, OptionRange):
        return value.low + next(shares) * (value.high - value.low)
    if isinstance(value, tuple):
        return tuple(_inside(item, shares) for item in value)
    return value


def _ends(value: Any) -> list[Any] | None:
    """The values of an option at its corners; None where an end is not known, or of too many."""
    if isinstance(value, OptionRange):
        if not (math.isfinite(value.low) and math.isfinite(value.high)):
            return None
        return [value.low] if value.low == value.high else [value.low, value.high]
    if isinstance(value, tuple):
        parts = [_ends(item) for item in value]
        known = [part for part in parts if part is not None]
        too_many = math.prod(map(len, known)) > _MOST_CORNERS
        return None if len(known) < len(parts) or too_many else list(product(*known))
    return [value]


def _is_integer(type: object) -> bool:
    return isinstance(type, QuantityType) and type.is_integer
