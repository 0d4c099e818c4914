"""What depends on which draws, found without evaluating anything."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ..ir.contained_values import values_in
from ..ir.scenario import Named
from ..ir.values import Draw, Entity, Reference, Value


def walk(value: Value | None, named: Mapping[str, Named]) -> Iterator[Value]:
    """A value and everything inside it, through the names it uses."""
    if value is None:
        return
    yield value
    if isinstance(value, Reference):
        yield from walk(named[value.name].value, named)
    for child in values_in(value):
        yield from walk(child, named)


def draws_in(value: Value | None, named: Mapping[str, Named]) -> Iterator[Draw]:
    """All draws that a value depends on."""
    return (item for item in walk(value, named) if isinstance(item, Draw))


def entities_in(value: Value | None, named: Mapping[str, Named]) -> Iterator[Entity]:
    """All declared things that a value names."""
    return (item for item in walk(value, named) if isinstance(item, Entity))
