"""Values of options as kinds get them: in SI units, lists as tuples."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from . import option_types as types
from .option_types import OptionType


def fits(value: Any, type_: OptionType) -> bool:
    """Whether a kind may get a value for an option of this type. Lists are tuples."""
    if isinstance(type_, types.QuantityType):
        return _is_number(value) and (isinstance(value, int) or not type_.is_integer)
    if isinstance(type_, types.LikeType):
        return _is_number(value)
    if isinstance(type_, types.FlagType):
        return isinstance(value, bool)
    if isinstance(type_, types.TextType | types.FileType | types.KindNameType):
        return isinstance(value, str)
    if isinstance(type_, types.UnionType):
        return any(fits(value, part) for part in type_.alternatives)
    return isinstance(type_, types.AnyType) or _is_tuple_of(value, type_)


def _is_tuple_of(value: Any, type_: OptionType) -> bool:
    if not isinstance(value, tuple):
        return False  # names of things, calls, maps and conditions: None is their only default
    if isinstance(type_, types.ListType):
        return len(value) >= type_.at_least and all(fits(item, type_.item) for item in value)
    if isinstance(type_, types.IntervalType):
        pair = len(value) == 2 and all(fits(item, type_.item) for item in value)
        return pair and value[0] <= value[1]
    if isinstance(type_, types.PointType):
        return len(value) == len(type_.parts) and all(map(_is_number, value))
    return isinstance(type_, types.NamesType) and all(isinstance(item, str) for item in value)


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and value == value


def numbers_in(value: Any) -> Iterator[float]:
    """The numbers of a value that the bounds of its option are about."""
    if isinstance(value, tuple):
        for item in value:
            yield from numbers_in(item)
    elif _is_number(value):
        yield float(value)
