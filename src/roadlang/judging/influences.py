"""What a requirement depends on: roads, networks and images, and whether a draw has a say."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import partial

from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scenario import ScenarioActor
from ..ir.values import Condition, PassCall
from ..world.placement.placement_order import placement_order


@dataclass(frozen=True, slots=True)
class Influences:
    """What decides a verdict, or where an agent or object begins.

    `names`: roads, networks and images, `is_random`: whether some draw does. Agents and objects in
    between have left theirs here.
    """

    names: frozenset[str]
    is_random: bool


def influences(test: Condition | PassCall, scenario: IndexedScenario) -> Influences:
    """On a formula or monitor, through the things that it names."""
    named = {entity.name for entity in scenario.dependencies.entities(test)}
    return _joined(named, bool(scenario.dependencies.draws(test)), _of_actors(scenario), scenario)


def influences_on_start(actor: ScenarioActor, scenario: IndexedScenario) -> Influences:
    """On where an agent or object begins, and on how many of it do."""
    deciding = [value for name, value in actor.options.items() if name in ("count", "route")]
    named = _names_in(actor, scenario) - {actor.name}
    is_random = bool(scenario.dependencies.draws(actor.at, *deciding))
    return _joined(named, is_random, _of_actors(scenario), scenario)


def is_geometry_random(name: str, scenario: IndexedScenario) -> bool:
    """Whether a road, network or image differs between candidates."""
    declaration = scenario.declaration(name)
    return scenario.once(("random thing", name), partial(scenario.is_random, declaration))


def _joined(
    named: Iterable[str],
    is_random: bool,
    of_actors: Mapping[str, Influences],
    scenario: IndexedScenario,
) -> Influences:
    """What names stand for: things themselves, actors what decides them."""
    geometry = frozenset(name for name in named if name not in scenario.actors)
    actors = [of_actors[name] for name in named if name in of_actors]
    is_random = is_random or any(found.is_random for found in actors)
    is_random = is_random or any(is_geometry_random(name, scenario) for name in geometry)
    return Influences(geometry.union(*(found.names for found in actors)), is_random)


def influences_on_place(actor: ScenarioActor, scenario: IndexedScenario) -> Influences:
    """On where an agent or object finds room: as nothing overlaps, all that are placed before it
    have a say."""
    return _of_actors(scenario)[actor.name]


def _of_actors(scenario: IndexedScenario) -> Mapping[str, Influences]:
    return scenario.once("influences of actors", partial(_in_order_of_placement, scenario))


def _in_order_of_placement(scenario: IndexedScenario) -> Mapping[str, Influences]:
    """Of every agent and object, with those of all that are placed before it."""
    found: dict[str, Influences] = {}
    geometry: frozenset[str] = frozenset()
    is_random = False
    for actor in placement_order(scenario):
        new = _names_in(actor, scenario) - scenario.actors.keys() - geometry
        if new:
            geometry |= new
        values = (actor.at, actor.kind, *(value for value in actor.options.values()))
        is_random = is_random or bool(scenario.dependencies.draws(*values))
        is_random = is_random or any(is_geometry_random(name, scenario) for name in new)
        found[actor.name] = Influences(geometry, is_random)
    return found


def _names_in(actor: ScenarioActor, scenario: IndexedScenario) -> set[str]:
    """The road of an agent or object, and the things and actors that its options name."""
    values = [actor.at, *(value for value in actor.options.values())]
    named = {entity.name for entity in scenario.dependencies.entities(*values)}
    return named | ({actor.on} if actor.on is not None else set())
