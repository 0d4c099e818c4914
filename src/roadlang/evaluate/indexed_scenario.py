"""A scenario made ready to be evaluated: everything by its name, every kind loaded."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator
from contextlib import suppress
from functools import cached_property
from typing import Any, TypeVar

from ..diagnostics import Code, DiagnosticError, Span, diagnose
from ..ir.contained_values import values_in
from ..ir.scenario import (
    LANE_OPTIONS,
    Named,
    NameSource,
    Scenario,
    ScenarioActor,
    ScenarioImage,
    ScenarioNetwork,
    ScenarioRoad,
)
from ..ir.values import Entity, Items, PassCall, RandomValue, Reference, TextValue, Value
from ..plugins.finding import find_entry
from ..plugins.guard import plugin_guard
from ..plugins.kinds import Kind
from ..plugins.registry import KindEntry, Registry, UnknownKind
from ..plugins.value_bounds import ValueBounds
from .dependencies import Dependencies

T = TypeVar("T")
MeasureGeometry = Callable[[PassCall, Any, int], Any]
"""From the call of a number of the geometry (`length(street)`), a `CandidateBatch` and the number
of a road or copy to the values (V, 1)."""

_AFTERWARDS = ("perturb", "control")
"""Passes that leave the root of a road or network what it is."""

PassObserver = Callable[[PassCall, Any], None]
"""Called with a pass and what it made: a `Picture`, an `Extraction`, a `Curve` or a `RoadBatch`."""


class IndexedScenario:
    """What does not differ between candidates. `once` keeps what is computed for all of them.

    `measure` reads numbers off the geometry, which stands above this room: the world hands it in.
    """

    def __init__(self, source: Scenario, registry: Registry, measure: MeasureGeometry) -> None:
        self.source = source
        self.registry = registry
        self.measure = measure
        self.observer: PassObserver | None = None
        self.values: dict[str, Named] = {item.name: item for item in source.values}
        self.images: dict[str, ScenarioImage] = {item.name: item for item in source.images}
        self.networks: dict[str, ScenarioNetwork] = {item.name: item for item in source.networks}
        self.roads: dict[str, ScenarioRoad] = {item.name: item for item in source.roads}
        self._declarations: dict[str, ScenarioImage | ScenarioNetwork | ScenarioRoad] = {
            **self.images, **self.networks, **self.roads
        }  # fmt: skip
        self.actors: dict[str, ScenarioActor] = {
            item.name: item for item in (*source.agents, *source.objects)
        }
        self.agents = frozenset(agent.name for agent in source.agents)
        self.dependencies = Dependencies(self.values)
        self._computed: dict[Hashable, Any] = {}
        self._classes: dict[tuple[str, str], tuple[KindEntry, type[Kind]]] = {}

    def once(self, key: Hashable, compute: Callable[[], T]) -> T:
        """What `compute` gives, computed at most once for all candidates."""
        if key not in self._computed:
            self._computed[key] = compute()
        computed: T = self._computed[key]
        return computed

    def observed(self, call: PassCall, result: T) -> T:
        """What a pass made, after the observer has seen it."""
        if self.observer is not None:
            self.observer(call, result)
        return result

    def kind(self, call: PassCall) -> tuple[KindEntry, type[Kind]]:
        """The class that a call names. Raises RL470 when it cannot be imported."""
        key = (call.verb, call.kind)
        if key not in self._classes:
            self._classes[key] = self._load(call)
        return self._classes[key]

    def _load(self, call: PassCall) -> tuple[KindEntry, type[Kind]]:
        try:
            entry = find_entry(self.registry, call.verb, call.kind, call.span)
        except UnknownKind:
            raise DiagnosticError(
                diagnose(Code.KIND_NOT_INSTALLED, call.span, kind=f"{call.verb} {call.kind}")
            ) from None
        with plugin_guard(entry, call.span):
            return entry, entry.load()

    @cached_property
    def value_bounds(self) -> ValueBounds:
        """The least and the greatest number that each value can be, whatever is drawn."""
        return ValueBounds(self.value_of, self.kind)

    def value_of(self, name: str) -> Value:
        """What a `param` or `let` stands for."""
        return self.values[name].value

    def resolved(self, value: Value | None) -> Value | None:
        """The value behind a name, and behind the name that it may stand for."""
        while isinstance(value, Reference):
            value = self.value_of(value.name)
        return value

    def draws(self) -> Iterator[RandomValue]:
        """Every draw of the scenario; one that is used twice comes twice."""
        for value in values_in(self.source):
            yield from self.dependencies.draws(value)

    def calls(self) -> Iterator[PassCall]:
        """Every kind that the scenario names, with its options; each place once."""
        places: dict[tuple[Span | None, str, str], PassCall] = {}
        for value in values_in(self.source):
            for item in self.dependencies.contents(value):
                if isinstance(item, PassCall):
                    places.setdefault((item.span, item.verb, item.place), item)
        yield from places.values()

    def origins(self) -> dict[str, str]:
        """The distributions that bring the kinds of the scenario, and their versions."""
        return self.once("origins", self._origins)

    def _origins(self) -> dict[str, str]:
        found = {}
        for call in self.calls():
            with suppress(KeyError):
                origin = self.registry.find(call.verb, call.kind).origin
                found[origin.distribution] = origin.version
        return dict(sorted(found.items()))

    def declaration(self, name: str) -> ScenarioImage | ScenarioNetwork | ScenarioRoad:
        """The road, network or image of that name. Raises `KeyError`."""
        return self._declarations[name]

    def source_of(
        self, declaration: ScenarioImage | ScenarioNetwork | ScenarioRoad
    ) -> ScenarioImage | ScenarioNetwork | ScenarioRoad | None:
        """The thing that another is made from, where it has a name; none of a road that is joined
        of several, which is a root."""
        if not isinstance(declaration.source, NameSource) or self.is_joined(declaration):
            return None
        return self._declarations[declaration.source.name]

    def chain(
        self, declaration: ScenarioImage | ScenarioNetwork | ScenarioRoad
    ) -> Iterator[ScenarioImage | ScenarioNetwork | ScenarioRoad]:
        """A declaration, the thing that it is made from, and so on."""
        link: ScenarioImage | ScenarioNetwork | ScenarioRoad | None = declaration
        while link is not None:
            yield link
            link = self.source_of(link)

    def roads_below(self, road: ScenarioRoad) -> Iterator[ScenarioRoad]:
        """A road, the road that it is made from, and so on."""
        return (link for link in self.chain(road) if isinstance(link, ScenarioRoad))

    def is_joined(self, declaration: ScenarioImage | ScenarioNetwork | ScenarioRoad) -> bool:
        """Whether a road is made of several, end to end."""
        return "then" in declaration.options

    def joined_roads(
        self, declaration: ScenarioImage | ScenarioNetwork | ScenarioRoad
    ) -> tuple[ScenarioRoad, ...]:
        """The roads that a road is joined of, in their order; none of any other."""
        if not self.is_joined(declaration):
            return ()
        assert isinstance(declaration.source, NameSource)
        following = [entity.name for entity in self._entities(declaration.options["then"])]
        return tuple(self.roads[name] for name in (declaration.source.name, *following))

    def _entities(self, value: Value) -> list[Entity]:
        """The named things of a value or a list, in their order."""
        found = self.resolved(value)
        items = found.items if isinstance(found, Items) else (found,)
        return [item for item in items if isinstance(item, Entity)]

    def ancestry(
        self, declaration: ScenarioImage | ScenarioNetwork | ScenarioRoad
    ) -> Iterator[ScenarioImage | ScenarioNetwork | ScenarioRoad]:
        """A thing and all that it is made from, roads that are joined included."""
        for link in self.chain(declaration):
            yield link
            for part in self.joined_roads(link):
                yield from self.ancestry(part)

    @cached_property
    def has_fixed_roots(self) -> bool:
        """Whether the root of no road or network is drawn, so that arrays hold many candidates."""
        return not any(map(self.is_varying, (*self.roads, *self.networks)))

    def is_varying(self, name: str) -> bool:
        """Whether the root of a road, network or image (what it is before any `perturb`) is drawn.

        Such roads differ in their stations, so that candidates are evaluated one by one.
        """
        return self.once(("varying", name), lambda: self._is_varying(self.declaration(name)))

    def _is_varying(self, declaration: ScenarioImage | ScenarioNetwork | ScenarioRoad) -> bool:
        return any(
            self._is_drawn(link) or any(map(self.is_random, self.joined_roads(link)))
            for link in self.chain(declaration)
        )

    def is_random(self, declaration: ScenarioImage | ScenarioNetwork | ScenarioRoad) -> bool:
        """Whether anything of a road, network or image is drawn: by its statement, or without any
        draw by the kinds of its passes (`harmonics`)."""
        for link in self.ancestry(declaration):
            if any(self.kind(call)[1].is_random for call in link.passes):
                return True
            if self._is_drawn(link) or self.dependencies.draws(
                *link.passes, *(value for value in link.options.values())
            ):
                return True
        return False

    def _is_drawn(self, declaration: ScenarioImage | ScenarioNetwork | ScenarioRoad) -> bool:
        shaping = [call for call in declaration.passes if call.verb not in _AFTERWARDS]
        if any(self.kind(call)[1].is_random for call in shaping):
            return True
        across = ("width", *LANE_OPTIONS)
        options = [value for name, value in declaration.options.items() if name not in across]
        if declaration.options.get("select") == TextValue("any"):
            return True
        return bool(self.dependencies.draws(*shaping, *options))
