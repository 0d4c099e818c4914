"""Options in words: for listings, the reference pages and the JSON Schema of a kind."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from ..syntax.words import RESERVED
from . import option_types as types
from .option_types import OptionType
from .options import OptionSchema


def type_text(option: OptionSchema) -> str:
    """What may be written for an option: `length (m)`, `integer | auto`."""
    if isinstance(option.type, types.WordType):
        return " | ".join(map(word_text, option.words)) or "one of the words of `option(words=...)`"
    if types.is_list_of_words(option.type):
        return f"list of {' | '.join(map(word_text, option.words))}"
    return " | ".join([_WORDS[type(option.type)](option.type), *map(word_text, option.words)])


def word_text(word: str) -> str:
    """A word as a scene file would write it: in quotes where it is no name, such as `"1.8"`."""
    is_bare = word.isascii() and word.isidentifier() and word not in RESERVED
    return word if is_bare else f'"{word}"'


def default_text(option: OptionSchema) -> str:
    """The default as a scene file would write it; empty where the option must be given."""
    if option.required:
        return ""
    return value_text(option.default, option.type)


def bounds_text(option: OptionSchema) -> str:
    """`>= 0m, < 1m`; empty without bounds."""
    limits = option.constraints
    pairs = (
        (">=", limits.minimum),
        (">", limits.above),
        ("<=", limits.maximum),
        ("<", limits.below),
    )
    return ", ".join(
        f"{sign} {value_text(float(value), option.type)}"
        for sign, value in pairs
        if value is not None
    )


def value_text(value: Any, type_: OptionType) -> str:
    """A value in SI units as a scene file would write it."""
    if value is None:
        return "not set"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return word_text(value)
    if isinstance(value, int | float):
        return _quantity_text(float(value), type_)
    if isinstance(value, tuple | list):
        if isinstance(type_, types.PointType):
            pair = zip(value, type_.parts, strict=True)
            return f"({', '.join(value_text(item, part) for item, part in pair)})"
        return f"[{', '.join(value_text(item, _item_type(type_)) for item in value)}]"
    return str(value)


def _quantity_text(value: float, type_: OptionType) -> str:
    if math.isinf(value):
        return "inf" if value > 0 else "-inf"
    unit = _unit(type_)
    if unit == "rad":
        degrees = math.degrees(value)
        if abs(degrees - round(degrees, 1)) < 0.01:
            return f"{round(degrees, 1):g}deg"
    if unit == "m/s" and f"{value:g}" != f"{value:.3g}" and round(value * 3.6, 6).is_integer():
        return f"{value * 3.6:g}km/h"
    return f"{value:.10g}{unit[1:] if unit.startswith('1/') else unit}"


def _unit(type_: OptionType) -> str:
    if isinstance(type_, types.QuantityType | types.PointType):
        return type_.dimension.unit
    if isinstance(type_, types.IntervalType | types.ListType | types.MapType):
        return _unit(type_.item)
    if isinstance(type_, types.UnionType):
        return next(filter(None, map(_unit, type_.alternatives)), "")
    return ""


def _item_type(type_: OptionType) -> OptionType:
    if isinstance(type_, types.ListType | types.IntervalType):
        return type_.item
    return type_


def with_article(noun: str) -> str:
    """`a road`, `an agent`."""
    return f"an {noun}" if noun[0] in "aeio" else f"a {noun}"


def _of(type_: OptionType) -> str:
    return _WORDS[type(type_)](type_)


def _plural(type_: OptionType) -> str:
    """Several of a type: `points (m)`, `lists of numbers`."""
    noun, space, rest = _of(type_).partition(" ")
    if not noun.isalpha():
        return f"items `{_of(type_)}`"
    return f"{noun}s{space}{rest}"


def _quantity(type_: types.QuantityType) -> str:
    if type_.is_integer:
        return "integer"
    noun = str(type_.dimension).removeprefix("an ").removeprefix("a ")
    noun = "number" if noun == "dimensionless number" else noun
    unit = type_.dimension.unit
    return f"{noun} ({unit})" if unit and "quantity" not in noun else noun


_WORDS: dict[type, Callable[[Any], str]] = {
    types.QuantityType: _quantity,
    types.LikeType: lambda t: "number with the same unit as the others",
    types.FlagType: lambda t: "true | false",
    types.TextType: lambda t: "string",
    types.FileType: lambda t: "file name",
    types.WordType: lambda t: "word",
    types.ListType: lambda t: f"list of {_plural(t.item)}",
    types.IntervalType: lambda t: f"interval [a, b] of {_plural(t.item)}",
    types.PointType: lambda t: (
        f"point{' in space' * t.in_space} ({t.dimension.unit})"
        if t.second is None
        else f"pair ({t.dimension.unit}, {t.second.unit})"
    ),
    types.EntityType: lambda t: "name of " + " or ".join(map(with_article, t.roles)),
    types.NamesType: lambda t: (
        ("name of an expectation" if t.word else "name of a requirement or expectation")
        + ", or a list of names"
    ),
    types.CallType: lambda t: "road selector" if t.verb == "select" else str(t.verb),
    types.KindNameType: lambda t: f"kind of {t.verb}",
    types.RecordType: lambda t: "record { ... }",
    types.MapType: lambda t: f"map to {_plural(t.item)}",
    types.ConditionType: lambda t: "formula over the drive",
    types.AnyType: lambda t: "value of any type",
    types.UnionType: lambda t: " | ".join(
        _of(item) for item in t.alternatives if not isinstance(item, types.WordType)
    ),
}
