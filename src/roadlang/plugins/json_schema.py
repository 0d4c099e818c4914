"""The JSON Schema of a kind's options, as they stand in a scene: SI units and radians."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from ..ir.schema import Schema, any_of, array, document
from . import option_types as types
from .describing import type_text
from .option_types import OptionType
from .options import OptionSchema, schema_of
from .registry import KindEntry

_LIMITS = {
    "minimum": "minimum",
    "maximum": "maximum",
    "above": "exclusiveMinimum",
    "below": "exclusiveMaximum",
}


def schema_of_kind(entry: KindEntry) -> Schema:
    """The document of a kind."""
    return document(
        f"roadlang.kind/{entry.origin.plugin}/{entry.verb}/{entry.name}",
        {"description": entry.help, **schema_of_options(entry.options)},
        title=f"{entry.verb} {entry.name}",
    )


def schema_of_options(options: Sequence[OptionSchema]) -> Schema:
    """An object with a property for each option."""
    return {
        "type": "object",
        "properties": {option.name: _option(option) for option in options},
        "required": [option.name for option in options if option.required],
        "additionalProperties": False,
    }


def _option(option: OptionSchema) -> Schema:
    schema = dict(_type(option.type))
    for name, keyword in _LIMITS.items():
        limit = getattr(option.constraints, name)
        if limit is not None:
            schema[keyword] = limit
    alternatives = [schema]
    if option.words:
        words = {"enum": list(option.words)}
        alternatives = [words] if isinstance(option.type, types.WordType) else [schema, words]
        if isinstance(option.type, types.ListType) and types.is_list_of_words(option.type):
            alternatives = [array(words, option.type.at_least)]
    if not option.required and option.default is None:
        alternatives.append({"type": "null"})
    described = "; ".join(filter(None, [option.help, type_text(option)]))
    default = {} if option.required else {"default": option.default}
    return {"description": described, **any_of(alternatives), **default}


def _type(type_: OptionType) -> Schema:
    return _SCHEMAS.get(type(type_), lambda _: {})(type_)


_SCHEMAS: dict[type, Callable[[Any], Schema]] = {
    types.QuantityType: lambda t: {"type": "integer" if t.is_integer else "number"},
    types.LikeType: lambda t: {"type": "number"},
    types.FlagType: lambda t: {"type": "boolean"},
    types.TextType: lambda t: {"type": "string"},
    types.FileType: lambda t: {"type": "string"},
    types.WordType: lambda t: {"type": "string"},
    types.ListType: lambda t: array(_type(t.item), t.at_least),
    types.IntervalType: lambda t: array(_type(t.item), 2, 2),
    types.PointType: lambda t: array({"type": "number"}, len(t.parts), len(t.parts)),
    types.EntityType: lambda t: {"type": "string"},
    types.CallType: lambda t: {"type": "object"},
    types.KindNameType: lambda t: {"type": "string"},
    types.RecordType: lambda t: schema_of_options(schema_of(t.record)),
    types.MapType: lambda t: {"type": "object", "additionalProperties": _type(t.item)},
    types.ConditionType: lambda t: {"type": "object"},
    types.UnionType: lambda t: {"anyOf": [_type(item) for item in t.alternatives]},
}
