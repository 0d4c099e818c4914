"""Options that a program gives: Python values in SI units and radians, checked as those of a scene
file are."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from ..diagnostics import Code, Diagnostic, diagnose, did_you_mean
from ..diagnostics.arguments import shown
from ..ir.units import TwoSlashes, UnknownUnit, parse_unit
from . import option_types as types
from .describing import bounds_text, type_text, value_text
from .option_types import OptionType, is_list_of_words
from .option_values import fits, numbers_in
from .options import OptionSchema

_OWN = (types.EntityType, types.CallType, types.RecordType, types.MapType, types.ConditionType)
"""Types whose values are objects of the kind's own, such as the traces of agents."""
_QUANTITY = re.compile(r"\s*([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)\s*([^0-9\s].*?)?\s*\Z")


def given_options(schemas: Sequence[OptionSchema], options: Mapping[str, Any]) -> dict[str, Any]:
    """The options as a kind gets them: numbers of numpy as those of Python, whole ones as integers
    where the option is one, lists as tuples."""
    known = {schema.name: schema.type for schema in schemas}
    return {name: _plain(value, known.get(name)) for name, value in options.items()}


def _plain(value: Any, type_: OptionType | None) -> Any:
    if hasattr(value, "item") and getattr(value, "shape", None) == ():
        value = value.item()
    if isinstance(value, list | tuple):
        item = type_.item if isinstance(type_, types.ListType) else None
        return tuple(_plain(each, item) for each in value)
    is_integer = isinstance(type_, types.QuantityType) and type_.is_integer
    return int(value) if is_integer and isinstance(value, float) and value.is_integer() else value


def option_faults(
    owner: str, schemas: Sequence[OptionSchema], options: Mapping[str, Any]
) -> list[Diagnostic]:
    """RL220 for names that are no options of `owner`; of those that are, RL206 and RL223 for values
    of another type, RL208 for numbers out of bounds."""
    known = [schema.name for schema in schemas]
    faults = [
        diagnose(
            Code.UNKNOWN_OPTION,
            owner=owner,
            name=name,
            help=did_you_mean(name, known) or f"its options are {', '.join(known) or 'none'}",
        )
        for name in options
        if name not in known
    ]
    for schema in schemas:
        if schema.name in options:
            faults += _value_faults(schema, options[schema.name])
    return faults


def _value_faults(schema: OptionSchema, value: Any) -> Iterator[Diagnostic]:
    if _is_own(schema.type) or (value is None and schema.default is None):
        return
    if schema.words and isinstance(value, str) and not is_list_of_words(schema.type):
        if value not in schema.words and not fits(value, schema.type):
            help_ = did_you_mean(value, schema.words) or f"allowed: {type_text(schema)}"
            yield diagnose(Code.UNKNOWN_OPTION_VALUE, word=value, help=help_)
    elif not _fits(value, schema):
        yield diagnose(
            Code.WRONG_TYPE,
            what=f"`{schema.name}`",
            expected=type_text(schema),
            found=shown(value),
            help=_quantity_help(schema, value),
        )
    elif not all(schema.constraints.allow(number) for number in numbers_in(value)):
        found = value_text(float(value), schema.type) if _is_number(value) else shown(value)
        yield diagnose(
            Code.VALUE_OUT_OF_BOUNDS,
            what=f"`{schema.name}`",
            expected=f"be {bounds_text(schema)}",
            found=f"is {found}",
        )


def _is_own(type_: OptionType) -> bool:
    parts = type_.alternatives if isinstance(type_, types.UnionType) else (type_,)
    return any(
        isinstance(part, _OWN) or (isinstance(part, types.ListType) and _is_own(part.item))
        for part in parts
    )


def _fits(value: Any, schema: OptionSchema) -> bool:
    if is_list_of_words(schema.type):
        return isinstance(value, tuple) and all(word in schema.words for word in value)
    return fits(value, schema.type)


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float)


def _quantity_help(schema: OptionSchema, value: Any) -> tuple[str, ...]:
    """For a text such as `2s`, the number that it stands for."""
    match = _QUANTITY.match(value) if isinstance(value, str) else None
    if match is None or not isinstance(schema.type, types.QuantityType):
        return ()
    try:
        unit, number = parse_unit(match[2] or ""), float(match[1])
    except (UnknownUnit, TwoSlashes, ValueError):
        return ()
    if match[2] and unit.dimension != schema.type.dimension:
        return ()
    return (f"write `{schema.name}={number * unit.factor:g}`: numbers from Python have SI units",)
