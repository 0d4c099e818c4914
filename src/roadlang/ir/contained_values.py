"""The values directly inside a part of the scenario, found by the fields of its dataclasses."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from functools import cache
from typing import Any, get_args

from . import scenario, values
from .read_only import FrozenDict
from .values import Value

_VALUES = get_args(Value)


@cache
def nodes() -> dict[str, Any]:
    """Every dataclass of the scenario and its values, by name."""
    return {
        name: member
        for module in (values, scenario)
        for name, member in vars(module).items()
        if dataclasses.is_dataclass(member) and member.__module__ == module.__name__
    }


def values_in(node: Any) -> Iterator[Value]:
    """The values directly inside a dataclass of the scenario, in the order of its fields."""
    kind: Any = type(node)
    for name in _field_names(kind):
        yield from _values(getattr(node, name))


@cache
def _field_names(kind: Any) -> tuple[str, ...]:
    return tuple(field.name for field in dataclasses.fields(kind))


def _values(member: Any) -> Iterator[Value]:
    if isinstance(member, _VALUES):
        yield member
    elif isinstance(member, tuple | FrozenDict):
        for item in member if isinstance(member, tuple) else member.values():
            yield from _values(item)
    elif type(member) is nodes().get(type(member).__name__):
        yield from values_in(member)
