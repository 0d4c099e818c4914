"""What depends on which draws, found without evaluating anything."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ..ir.scenario import Named
from ..ir.values import (
    Condition,
    Draw,
    Entity,
    Entries,
    Items,
    Measure,
    Operation,
    PassCall,
    Reference,
    Value,
)


def children(value: Value) -> Iterator[Value]:
    """The values directly inside a value."""
    if isinstance(value, Draw | Measure):
        yield value.call
    elif isinstance(value, Operation):
        yield from value.operands
    elif isinstance(value, Items):
        yield from value.items
    elif isinstance(value, Entries):
        yield from (item for _, item in value.entries)
    elif isinstance(value, PassCall):
        yield from (item for _, item in (*value.options, *value.common))
    elif isinstance(value, Condition):
        yield from (binding.call for binding in value.signals)
        yield from (binding.value for binding in value.numbers)


def walk(value: Value | None, named: Mapping[str, Named]) -> Iterator[Value]:
    """A value and everything inside it, through the names it uses."""
    if value is None:
        return
    yield value
    if isinstance(value, Reference):
        yield from walk(named[value.name].value, named)
    for child in children(value):
        yield from walk(child, named)


def draws_in(value: Value | None, named: Mapping[str, Named]) -> Iterator[Draw]:
    """All draws that a value depends on."""
    return (item for item in walk(value, named) if isinstance(item, Draw))


def entities_in(value: Value | None, named: Mapping[str, Named]) -> Iterator[Entity]:
    """All declared things that a value names."""
    return (item for item in walk(value, named) if isinstance(item, Entity))
