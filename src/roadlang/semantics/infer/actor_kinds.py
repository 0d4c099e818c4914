"""The kinds that an agent or object may be, and the options they share."""

from __future__ import annotations

from dataclasses import replace

from ...ir.read_only import FrozenDict
from ...ir.values import Items, Options, PassCall, RandomValue, Value
from ...plugins.options import OptionSchema, schema_of
from ...plugins.registry import KindEntry
from ..checker import Checker


def calls_in(value: Value) -> list[PassCall]:
    """The calls of kinds in `car`, or in `choice(car, truck)`."""
    if isinstance(value, PassCall) and value.verb in ("agent", "object"):
        return [value]
    if isinstance(value, RandomValue):
        return [call for option in value.call.options.values() for call in calls_in(option)]
    if isinstance(value, Items):
        return [call for item in value.items for call in calls_in(item)]
    return []


def shared_options(checker: Checker, calls: list[PassCall]) -> list[OptionSchema]:
    """The options that all these kinds have."""
    schemas = [
        {option.name: option for option in schema_of(_entry(checker, call).load())}
        for call in calls
    ]
    if not schemas:
        return []
    first, *others = schemas
    return [
        option for name, option in first.items()
        if all(name in other and other[name].type == option.type for other in others)
    ]  # fmt: skip


def _entry(checker: Checker, call: PassCall) -> KindEntry:
    return checker.registry.find(call.verb, call.kind)


def with_options(checker: Checker, value: Value, options: Options) -> Value:
    """The kind, or each kind of the draw, with the options of the statement's block."""
    if not options:
        return value
    if isinstance(value, PassCall) and value.verb in ("agent", "object"):
        others = {name: written for name, written in value.options.items() if name not in options}
        return replace(value, options=FrozenDict({**others, **options}))
    if isinstance(value, RandomValue):
        inner = {
            name: with_options(checker, option, options)
            for name, option in value.call.options.items()
        }
        return replace(value, call=replace(value.call, options=FrozenDict(inner)))
    if isinstance(value, Items):
        return Items(tuple(with_options(checker, item, options) for item in value.items))
    return value
