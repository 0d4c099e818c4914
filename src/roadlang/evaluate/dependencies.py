"""What depends on which draws, found without evaluating anything."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ..ir.contained_values import values_in
from ..ir.scenario import Named
from ..ir.values import Draw, Entity, Reference, Value


def walk(value: Value | None, named: Mapping[str, Named]) -> Iterator[Value]:
    """A value and everything inside it, through the names it uses: each of these once."""
    pending = [] if value is None else [value]
    seen: set[str] = set()
    while pending:
        item = pending.pop()
        yield item
        inside = list(values_in(item))
        if isinstance(item, Reference) and item.name not in seen:
            seen.add(item.name)
            inside.insert(0, named[item.name].value)
        pending.extend(reversed(inside))


def draws_in(value: Value | None, named: Mapping[str, Named]) -> Iterator[Draw]:
    """All draws that a value depends on."""
    return (item for item in walk(value, named) if isinstance(item, Draw))


def entities_in(value: Value | None, named: Mapping[str, Named]) -> Iterator[Entity]:
    """All declared things that a value names."""
    return (item for item in walk(value, named) if isinstance(item, Entity))
