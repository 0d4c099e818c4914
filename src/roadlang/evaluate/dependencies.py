"""What values contain and depend on, found without evaluating anything."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..ir.contained_values import values_in
from ..ir.scenario import Named
from ..ir.values import Entity, Measure, RandomValue, Reference, Value


class Dependencies:
    """Everything inside the values of a scenario, through the names that they use.

    What is found is kept for each value, as candidates are evaluated many times.
    """

    def __init__(self, named: Mapping[str, Named]) -> None:
        self._named = named
        # By identity, with the value, so that no other gets its identity: values are large.
        self._contents: dict[int, tuple[Value, tuple[Value, ...]]] = {}

    def __reduce__(self) -> tuple[Any, ...]:
        # Identities mean nothing in another process.
        return Dependencies, (self._named,)

    def contents(self, value: Value | None) -> tuple[Value, ...]:
        """A value and everything inside it; what several parts use by name comes once."""
        if value is None:
            return ()
        if id(value) not in self._contents:
            self._contents[id(value)] = value, self._walk(value)
        return self._contents[id(value)][1]

    def draws(self, *values: Value | None) -> tuple[RandomValue, ...]:
        """All draws that values depend on."""
        return tuple(
            i for value in values for i in self.contents(value) if isinstance(i, RandomValue)
        )

    def differ(self, *values: Value | None) -> bool:
        """Whether values depend on draws, or on what is measured of a scene."""
        kinds = (RandomValue, Measure)
        return any(isinstance(i, kinds) for value in values for i in self.contents(value))

    def entities(self, *values: Value | None) -> tuple[Entity, ...]:
        """All declared things that values name."""
        return tuple(i for value in values for i in self.contents(value) if isinstance(i, Entity))

    def _walk(self, value: Value) -> tuple[Value, ...]:
        found: list[Value] = []
        pending = [value]
        seen: set[str] = set()
        while pending:
            item = pending.pop()
            found.append(item)
            inside = list(values_in(item))
            if isinstance(item, Reference) and item.name not in seen:
                seen.add(item.name)
                inside.insert(0, self._named[item.name].value)
            pending.extend(reversed(inside))
        return tuple(found)
