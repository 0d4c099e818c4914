"""In which order agents and objects are placed: first what stands where it is said, then the rest.

A thing comes after all that decide where it is, and what has no draws of its own right after the
last of them, so that those that can be placed again keep clear of it.
"""

from __future__ import annotations

import heapq

from ...evaluate.candidates import CandidateBatch
from ...evaluate.draw_names import coordinate_name
from ...evaluate.indexed_scenario import IndexedScenario
from ...ir.contained_values import values_in
from ...ir.scenario import ScenarioActor
from ...ir.values import RandomValue, Value
from .copies import is_group, most_copies

PLACING = ("at", "offset", "lane", "side", "facing", "heading", "spacing")
"""What decides where a copy stands, of which the draws are made again"""


def placement_order(scenario: IndexedScenario) -> tuple[ScenarioActor, ...]:
    """All agents and objects; agents before objects where nothing else decides."""
    return scenario.once("placement order", lambda: _ordered(scenario))


def draws_of(actor: ScenarioActor, scenario: IndexedScenario) -> tuple[RandomValue, ...]:
    """The draws of its own statement that decide where an agent or object stands."""

    def find() -> tuple[RandomValue, ...]:
        values = [actor.at, *(v for name, v in actor.options.items() if name in PLACING)]
        found = []
        while values:
            value = values.pop()
            found += [value] if isinstance(value, RandomValue) else []
            values += list(values_in(value))  # not through names: these are drawn once for all
        return tuple(found)

    return scenario.once(("own draws", actor.name), find)


def can_be_placed_again(actor: ScenarioActor, candidates: CandidateBatch) -> bool:
    """Whether draws decide where it stands, and no sampler has chosen them."""
    draws = draws_of(actor, candidates.scenario)
    if not draws or not candidates.coordinates:
        return bool(draws)
    copies = range(1, most_copies(actor, candidates) + 1) if is_group(actor) else (0,)
    names = (
        coordinate_name(draw.place, 0 if draw.per == "scene" else copy)
        for draw in draws
        for copy in copies
    )
    return not any(name in candidates.coordinates for name in names)


def deciding_actors(scenario: IndexedScenario, *values: Value, names: set[str]) -> set[str]:
    """The agents and objects that values name, by themselves or through the roads that they name
    and those of `things`."""
    actors: set[str] = set()
    seen: set[str] = set()
    read: list[Value] = list(values)
    while read or names:
        named = {entity.name for entity in scenario.dependencies.entities(*read)}
        actors |= named & scenario.actors.keys()
        read = []
        for name in (names | named) - scenario.actors.keys() - seen:
            for link in scenario.ancestry(scenario.declaration(name)):
                seen.add(link.name)
                read += [*(value for value in link.options.values()), *link.passes]
        names = set()
    return actors


def _ordered(scenario: IndexedScenario) -> tuple[ScenarioActor, ...]:
    actors = list(scenario.actors.values())
    number = {actor.name: index for index, actor in enumerate(actors)}
    after: dict[str, list[str]] = {name: [] for name in number}
    waiting: dict[str, int] = {}
    for actor in actors:
        on = {actor.on} if actor.on is not None else set()
        values = [actor.at, actor.kind, *(value for value in actor.options.values())]
        before = deciding_actors(scenario, *values, names=on) - {actor.name}
        waiting[actor.name] = len(before)
        for name in before:
            after[name].append(actor.name)
    ready = [_rank(actor, number, scenario) for actor in actors if not waiting[actor.name]]
    heapq.heapify(ready)
    order: list[ScenarioActor] = []
    while ready:
        actor = actors[heapq.heappop(ready)[1]]
        order.append(actor)
        for name in after[actor.name]:
            waiting[name] -= 1
            if waiting[name] == 0:
                heapq.heappush(ready, _rank(scenario.actors[name], number, scenario))
    return tuple(order)


def _rank(
    actor: ScenarioActor, number: dict[str, int], scenario: IndexedScenario
) -> tuple[bool, int]:
    return bool(draws_of(actor, scenario)), number[actor.name]
