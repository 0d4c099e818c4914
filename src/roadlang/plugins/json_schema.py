"""The JSON Schema of a kind's options, as they stand in a scene: SI units and radians."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from . import option_types as types
from .describing import type_text
from .option_types import OptionType
from .options import OptionSchema
from .registry import KindEntry

_DRAFT = "https://json-schema.org/draft/2020-12/schema"
_LIMITS = {
    "minimum": "minimum",
    "maximum": "maximum",
    "above": "exclusiveMinimum",
    "below": "exclusiveMaximum",
}


def schema_of_kind(entry: KindEntry) -> dict[str, Any]:
    """An object with a property for each option."""
    return {
        "$schema": _DRAFT,
        "$id": f"roadlang.kind/{entry.origin.plugin}/{entry.verb}/{entry.name}",
        "title": f"{entry.verb} {entry.name}",
        "description": entry.help,
        "type": "object",
        "properties": {option.name: _option(option) for option in entry.options},
        "required": [option.name for option in entry.options if option.required],
        "additionalProperties": False,
    }


def _option(option: OptionSchema) -> dict[str, Any]:
    schema = dict(_type(option.type))
    for name, keyword in _LIMITS.items():
        limit = getattr(option.constraints, name)
        if limit is not None:
            schema[keyword] = limit
    alternatives = [schema]
    if option.words:
        words = {"enum": list(option.words)}
        alternatives = [words] if isinstance(option.type, types.WordType) else [schema, words]
    if not option.required and option.default is None:
        alternatives.append({"type": "null"})
    whole = alternatives[0] if len(alternatives) == 1 else {"anyOf": alternatives}
    described = "; ".join(filter(None, [option.help, type_text(option)]))
    default = {} if option.required else {"default": option.default}
    return {"description": described, **whole, **default}


def _type(type_: OptionType) -> dict[str, Any]:
    return _SCHEMAS.get(type(type_), lambda _: {})(type_)


_SCHEMAS: dict[type, Callable[[Any], dict[str, Any]]] = {
    types.QuantityType: lambda t: {"type": "integer" if t.whole else "number"},
    types.LikeType: lambda t: {"type": "number"},
    types.FlagType: lambda t: {"type": "boolean"},
    types.TextType: lambda t: {"type": "string"},
    types.FileType: lambda t: {"type": "string"},
    types.WordType: lambda t: {"type": "string"},
    types.ListType: lambda t: {"type": "array", "items": _type(t.item), "minItems": t.at_least},
    types.IntervalType: lambda t: _tuple(_type(t.item)),
    types.PointType: lambda t: _tuple({"type": "number"}),
    types.EntityType: lambda t: {"type": "string"},
    types.CallType: lambda t: {"type": "object"},
    types.KindNameType: lambda t: {"type": "string"},
    types.RecordType: lambda t: {"type": "object"},
    types.MapType: lambda t: {"type": "object", "additionalProperties": _type(t.item)},
    types.ConditionType: lambda t: {"type": "object"},
    types.UnionType: lambda t: {"anyOf": [_type(item) for item in t.alternatives]},
}


def _tuple(item: dict[str, Any]) -> dict[str, Any]:
    return {"type": "array", "items": item, "minItems": 2, "maxItems": 2}
