"""Whether numbers that are drawn or computed keep the bounds of their options.

Constants are checked with the file, and so are draws as far as it is known what they can be. What
nothing bounds, such as `normal(...)`, is checked as it is drawn.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..diagnostics import Code, DiagnosticError, Span, diagnose
from ..ir.values import PassCall
from ..plugins.common_options import common_options
from ..plugins.option_types import (
    AnyType,
    IntervalType,
    LikeType,
    ListType,
    MapType,
    OptionType,
    QuantityType,
    RecordType,
    UnionType,
)
from ..plugins.options import OptionSchema, schema_of


def options_of(kind: type, verb: str) -> Mapping[str, OptionSchema]:
    """The options of a kind and those of its verb, by name."""
    return _options_of(kind, verb)


@cache
def common_option(verb: str, name: str) -> OptionSchema:
    """An option that all kinds of a verb have."""
    return next(option for option in common_options(verb) if option.name == name)


@cache
def _options_of(kind: Any, verb: str) -> Mapping[str, OptionSchema]:
    return {option.name: option for option in (*common_options(verb), *schema_of(kind))}


def check_bounds(option: OptionSchema, value: Any, call: PassCall) -> None:
    """A number (or a column of them) in an option of a call. Raises RL473."""
    span = call.option_spans.get(option.name, call.span)
    check_number(option, value, call.kind.rpartition(".")[2], span)


def check_number(option: OptionSchema, value: Any, owner: str, span: Span | None) -> None:
    """The same in an option of an `owner`, and of the numbers in lists, maps and records, which
    have the bounds that hold for constants. What is no number has no bounds. Raises RL473."""
    limits = option.constraints
    if isinstance(value, float | int) and not math.isnan(value) and limits.allow(value):
        return
    if isinstance(value, tuple | Mapping) and not _holds_numbers(option.type):
        return  # a road may be drawn through thousands of points
    for part, number, of in _numbers(option, value, owner):
        _check_column(part, number, of, span)


@cache
def _holds_numbers(type_: OptionType) -> bool:
    """Whether there may be numbers in values of a type, but for the coordinates of points."""
    if isinstance(type_, UnionType):
        return any(_holds_numbers(one) for one in type_.alternatives)
    if isinstance(type_, RecordType):
        return any(_holds_numbers(part.type) for part in schema_of(type_.record))
    if isinstance(type_, ListType | IntervalType | MapType):
        return _holds_numbers(type_.item)
    return isinstance(type_, QuantityType | LikeType | AnyType)


def _numbers(
    option: OptionSchema, value: Any, owner: str
) -> Iterator[tuple[OptionSchema, NDArray[Any], str]]:
    """The columns of numbers in the value of an option, with the option and its owner that bound
    each: those of a record have options of their own, and items have the bounds of the list."""
    if isinstance(value, float | int | np.ndarray) and not isinstance(value, bool):
        numbers = np.asarray(value)
        if numbers.dtype.kind in "fiu":
            yield option, numbers, owner
    elif isinstance(value, tuple | Mapping):
        type_ = option.type
        for one in type_.alternatives if isinstance(type_, UnionType) else (type_,):
            for part, item, of in _parts(option, one, value, owner):
                yield from _numbers(part, item, of)


def _parts(
    option: OptionSchema, type_: OptionType, value: tuple[Any, ...] | Mapping[str, Any], owner: str
) -> Iterator[tuple[OptionSchema, Any, str]]:
    """What is in a list, map or record, with the option that bounds it; nothing where the value is
    not of the type, and of points, whose numbers have no bounds."""
    if isinstance(value, tuple):
        if isinstance(type_, ListType | IntervalType):
            inner = replace(option, type=type_.item)
            yield from ((inner, item, owner) for item in value)
    elif isinstance(type_, MapType):
        inner = replace(option, type=type_.item)
        yield from ((inner, item, owner) for item in value.values())
    elif isinstance(type_, RecordType):
        for part in schema_of(type_.record):
            if part.name in value:
                yield part, value[part.name], option.name


def _check_column(
    option: OptionSchema, numbers: NDArray[Any], owner: str, span: Span | None
) -> None:
    limits = option.constraints
    wrong = np.isnan(numbers)
    for bound, outside in (
        (limits.least, np.less),
        (limits.most, np.greater),
        (limits.above, np.less_equal),
        (limits.below, np.greater_equal),
    ):
        if bound is not None:
            wrong = wrong | outside(numbers, bound)
    if wrong.any():
        found = float(numbers[wrong].reshape(-1)[0])
        raise DiagnosticError(
            diagnose(
                Code.DRAWN_VALUE_OUT_OF_BOUNDS,
                span,
                option=option.name,
                kind=owner,
                value=f"{found:g}",
            )
        )
