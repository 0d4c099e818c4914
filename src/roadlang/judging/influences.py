"""What a requirement depends on: the things that it names, and the draws behind them."""

from __future__ import annotations

from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scenario import ScenarioActor
from ..ir.values import Condition, PassCall


def names_in(test: Condition | PassCall, scenario: IndexedScenario) -> frozenset[str]:
    """The things that a formula or monitor names, and those that these stand on."""
    named = {entity.name for entity in scenario.dependencies.entities(test)}
    for actor in [scenario.actors[name] for name in named if name in scenario.actors]:
        named |= names_of_actor(actor, scenario)
    return frozenset(named)


def names_of_actor(actor: ScenarioActor, scenario: IndexedScenario) -> frozenset[str]:
    """The things that decide where an agent or object is, through those that it is placed by."""
    names: set[str] = set()
    pending = [actor]
    while pending:
        placed = pending.pop()
        values = [placed.at, *(value for _, value in placed.options)]
        found = {e.name for e in scenario.dependencies.entities(*values)}
        found |= {placed.on} if placed.on is not None else set()
        pending.extend(scenario.actors[name] for name in found - names if name in scenario.actors)
        names |= found
    return frozenset(names - {actor.name})


def influences(test: Condition | PassCall, scenario: IndexedScenario) -> frozenset[str]:
    """The places of all draws that can change a verdict, through the things that it names."""
    places = {draw.place for draw in scenario.dependencies.draws(test)}
    for name in names_in(test, scenario):
        places |= draws_of_thing(name, scenario)
    return frozenset(places)


def draws_of_start(actor: ScenarioActor, scenario: IndexedScenario) -> frozenset[str]:
    """The places of all draws that can change where an agent or object begins."""
    places = {draw.place for draw in scenario.dependencies.draws(actor.at)}
    for name in names_of_actor(actor, scenario):
        places |= draws_of_thing(name, scenario)
    return frozenset(places)


def draws_of_thing(name: str, scenario: IndexedScenario) -> set[str]:
    """The places of the draws behind a road, network, image, agent or object."""
    if name in scenario.actors:
        actor = scenario.actors[name]
        values = (actor.at, *(value for _, value in actor.options))
        return {d.place for d in scenario.dependencies.draws(*values)}
    places: set[str] = set()
    for link in scenario.chain(scenario.thing(name)):
        values = (*(value for _, value in link.options), *link.passes)
        places |= {d.place for d in scenario.dependencies.draws(*values)}
        # A pass that draws by itself (`harmonics`) differs between candidates without any draw.
        places |= {call.place for call in link.passes if _draws_itself(call, scenario)}
        if scenario.is_varying(name):
            places.add(f"{name}/select")
    return places


def _draws_itself(call: PassCall, scenario: IndexedScenario) -> bool:
    return scenario.kind(call)[1].is_random
