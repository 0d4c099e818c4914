"""What depends on which draws, found without evaluating anything."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from ..ir.scenario import Image, Named, Network, Road
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
    Text,
    Value,
)

if TYPE_CHECKING:
    from .indexed_scenario import IndexedScenario


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


class Varying:
    """Tells whether the root of a road or network (what it is before any `perturb`) is drawn.

    Such roads differ in their stations, so that candidates are evaluated one by one.
    """

    def __init__(self, scenario: IndexedScenario) -> None:
        self._scenario = scenario
        self._known: dict[str, bool] = {}

    def __call__(self, name: str) -> bool:
        """Whether the root of the road or network `name` is drawn."""
        if name not in self._known:
            self._known[name] = any(map(self._is_drawn, self._scenario.chain(self._thing(name))))
        return self._known[name]

    def _thing(self, name: str) -> Image | Network | Road:
        scenario = self._scenario
        thing: Image | Network | Road | None = scenario.roads.get(name) or scenario.networks.get(
            name
        )
        return thing if thing is not None else scenario.images[name]

    def _is_drawn(self, thing: Image | Network | Road) -> bool:
        shaping = [call for call in thing.passes if call.verb != "perturb"]
        if any(getattr(self._scenario.kind(call)[1], "is_random", False) for call in shaping):
            return True
        options = [value for name, value in thing.options if name not in ("width", "lanes")]
        if dict(thing.options).get("select") == Text("any"):
            return True
        return any(True for v in (*shaping, *options) for _ in draws_in(v, self._scenario.values))
