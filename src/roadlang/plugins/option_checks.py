"""Whether the default of an option is a value that a scene file could have given it."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any

from . import option_types as types
from .describing import bounds_text, type_text
from .option_types import OptionType
from .options import MutableDefault, OptionSchema

_WORD = re.compile(r"""[^\s"'`\\]([^"'`\\\n]*[^\s"'`\\])?\Z""")
"""What a scene file can have, bare or in quotes."""


def option_fault(option: OptionSchema) -> str | None:
    """What is wrong with the words, bounds or default of an option; None if nothing is."""
    for word in option.words:
        if not isinstance(word, str) or not _WORD.match(word) or not word.isprintable():
            return f"has the word {word!r}, which cannot be written in a scene file"
    if isinstance(option.type, types.WordType) and not option.words:
        return 'is a word, but has no words: write `option(words=("left", "right"))`'
    limits = option.constraints
    least = max((x for x in (limits.minimum, limits.above) if x is not None), default=-math.inf)
    most = min((x for x in (limits.maximum, limits.below) if x is not None), default=math.inf)
    if least > most:
        return f"allows no value: {bounds_text(option)}"
    return _default_fault(option)


def _default_fault(option: OptionSchema) -> str | None:
    value = option.default
    if option.required or value is None or (isinstance(value, str) and value in option.words):
        return None
    if isinstance(value, MutableDefault):
        instead = "None" if value.kind in ("dict", "set") else "a tuple"
        return f"has a {value.kind} as default, which all uses would share: write {instead}"
    if types.is_list_of_words(option.type):
        fits = isinstance(value, tuple) and all(word in option.words for word in value)
    else:
        fits = _fits(value, option.type)
    if not fits:
        return f"has the default {value!r}; expected: {type_text(option)}"
    if not all(option.constraints.allow(number) for number in _numbers(value)):
        return f"has the default {value!r}; expected: {bounds_text(option)}"
    return None


def _fits(value: Any, type_: OptionType) -> bool:
    if isinstance(type_, types.QuantityType):
        return _is_number(value) and (isinstance(value, int) or not type_.is_integer)
    if isinstance(type_, types.LikeType):
        return _is_number(value)
    if isinstance(type_, types.FlagType):
        return isinstance(value, bool)
    if isinstance(type_, types.TextType | types.FileType | types.KindNameType):
        return isinstance(value, str)
    if isinstance(type_, types.UnionType):
        return any(_fits(value, part) for part in type_.alternatives)
    return isinstance(type_, types.AnyType) or _is_tuple_of(value, type_)


def _is_tuple_of(value: Any, type_: OptionType) -> bool:
    if not isinstance(value, tuple):
        return False  # names of things, calls, maps and conditions: None is their only default
    if isinstance(type_, types.ListType):
        return len(value) >= type_.at_least and all(_fits(item, type_.item) for item in value)
    if isinstance(type_, types.IntervalType):
        pair = len(value) == 2 and all(_fits(item, type_.item) for item in value)
        return pair and value[0] <= value[1]
    if isinstance(type_, types.PointType):
        return len(value) == len(type_.parts) and all(map(_is_number, value))
    return isinstance(type_, types.NamesType) and all(isinstance(item, str) for item in value)


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and value == value


def _numbers(value: Any) -> Iterator[float]:
    """The numbers of a default that its bounds are about."""
    if isinstance(value, tuple):
        for item in value:
            yield from _numbers(item)
    elif _is_number(value):
        yield float(value)
