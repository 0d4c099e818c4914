"""Requirements judged for many candidates, cheap ones first, each for the survivors only."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..diagnostics import Code, DiagnosticError, Span, diagnose
from ..evaluate.candidates import CandidateBatch
from ..evaluate.dependencies import draws_in, entities_in, walk
from ..evaluate.evaluation import build, evaluate
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.batch import RoadBatch
from ..ir.scenario import Actor, Constraint, Network, Road
from ..ir.values import Condition, Draw, PassCall
from ..plugins.guard import wrong_result
from ..world.signals import Axis, axes_of, signal

Floats = NDArray[np.float64]
_PROJECTION = 4000.0
"""Work of finding the nearest point of another road, beside that of comparing stations."""


@dataclass(frozen=True)
class Requirement:
    """Something that every scene satisfies: a `require`, or what goes without saying.

    `names`: the roads and networks that it looks at, `draws` the places of the draws that it
    depends on, `cost` an estimate of its work for one station.
    """

    name: str
    text: str
    rho: Callable[[CandidateBatch], Floats]
    cost: float
    names: frozenset[str]
    draws: frozenset[str]
    implied: bool = False
    test: Condition | PassCall | None = None
    span: Span | None = None

    @cached_property
    def line(self) -> int | None:
        """Line of the statement, from 1; None for one that no line states."""
        return self.span.line if self.span is not None else None


def requirements_of(scenario: IndexedScenario) -> tuple[Requirement, ...]:
    """All requirements of a scenario, cheapest first; the order written breaks ties."""
    found = [_written(constraint, scenario) for constraint in scenario.source.requirements]
    found += [
        _placed(actor, scenario) for actor in scenario.actors.values() if actor.on is not None
    ]
    found += [_unfolded(name, scenario) for name in _bent_roads(scenario)]
    return tuple(sorted(found, key=lambda requirement: requirement.cost))


def condition_rho(condition: Condition, candidates: CandidateBatch) -> Floats:
    """(V,) robustness of a formula over roads or numbers; of a network, on its worst road."""
    worst = None
    for axis in axes_of(condition, candidates) if condition.domain == "road" else (Axis(),):
        for copy in range(1, copies_named(condition, candidates) + 1):
            rho = _rho_on(condition, axis, copy, candidates)
            worst = rho if worst is None else np.minimum(worst, rho)
    if worst is None:
        return np.full(candidates.count, np.inf)
    return np.broadcast_to(worst, (candidates.count,))


def axis_signals(
    condition: Condition, axis: Axis, copy: int, candidates: CandidateBatch
) -> tuple[Floats, dict[str, Any], float | None]:
    """Positions (S,), the values of all variables, and the length of a closed road."""
    values: dict[str, Any] = {}
    positions, wrap = np.zeros(1), None
    longest = 0
    for binding in condition.signals:
        values[binding.variable] = array = signal(binding.call, axis, candidates)
        for entity in _roads_named(binding.call, candidates):
            road = axis.resolve(entity, candidates)
            if not isinstance(road, RoadBatch):  # a number of a whole network has no axis
                break
            if array.shape[1] == len(road.stations) and len(road.stations) > longest:
                positions, wrap, longest = road.stations, road.period, len(road.stations)
            break
    for number in condition.numbers:
        value = evaluate(number.value, candidates, copy)
        values[number.variable] = value if isinstance(value, np.ndarray) else float(value)
    _check_shapes(condition, positions, values)
    return positions, values, wrap


def copies_named(condition: Condition, candidates: CandidateBatch) -> int:
    """How many copies the largest group has whose `start` the formula uses; 1 without any."""
    from ..world.placement import most_copies

    actors = candidates.scenario.actors
    groups = [
        actors[entity.name]
        for entity in entities_in(condition, candidates.scenario.values)
        if entity.role in ("agent", "object")
    ]
    return max((most_copies(actor, candidates) for actor in groups), default=1)


def _rho_on(condition: Condition, axis: Axis, copy: int, candidates: CandidateBatch) -> Floats:
    from ..world.placement import is_absent

    positions, values, wrap = axis_signals(condition, axis, copy, candidates)
    rho = np.atleast_1d(condition.formula.rho(positions, values, wrap=wrap))
    absent = is_absent(condition, copy, candidates)
    return rho if absent is None else np.where(absent, np.inf, rho)


def _check_shapes(condition: Condition, positions: Floats, values: dict[str, Any]) -> None:
    lengths = {v.shape[1] for v in values.values() if isinstance(v, np.ndarray) and v.ndim == 2}
    if len(lengths - {1, len(positions)}) > 0:
        spans = [binding.call.span for binding in condition.signals]
        raise DiagnosticError(
            diagnose(Code.ROADS_NOT_COMPARABLE, next(iter(spans), None), formula=condition.text)
        )


def _roads_named(call: PassCall, candidates: CandidateBatch) -> Any:
    return (
        entity
        for entity in entities_in(call, candidates.scenario.values)
        if entity.role in ("road", "network")
    )


def _written(constraint: Constraint, scenario: IndexedScenario) -> Requirement:
    test = constraint.test
    if isinstance(test, Condition):
        condition = test

        def rho(candidates: CandidateBatch) -> Floats:
            return condition_rho(condition, candidates)

        text = condition.text
    else:
        call = test

        def rho(candidates: CandidateBatch) -> Floats:
            return monitor_rho(call, candidates)

        text = f"with {test.kind}"
    return Requirement(
        constraint.name,
        text,
        rho,
        _cost(test, scenario),
        _names(test, scenario),
        influences(test, scenario),
        test=test,
        span=constraint.span,
    )


def monitor_rho(call: PassCall, candidates: CandidateBatch) -> Floats:
    """(V,) robustness that a monitor plugin gives; of networks, on their worst road."""
    worst = np.full(candidates.count, np.inf)
    for axis in axes_of(call, candidates):
        built = build(call, candidates, resolve=partial(axis.resolve, candidates=candidates))
        with built.guarded:
            rho = np.asarray(built.kind.robustness(), dtype=np.float64).reshape(-1)
        if rho.shape[0] not in (1, candidates.count):
            fault = f"gave a robustness of shape {rho.shape}, not ({candidates.count},)"
            raise wrong_result(built.entry, call.span, fault)
        if np.isnan(rho).any():
            raise wrong_result(built.entry, call.span, "gave a robustness that is no number")
        worst = np.minimum(worst, rho)
    return worst


def _cost(test: Condition | PassCall, scenario: IndexedScenario) -> float:
    """Signals cost what their kinds say, temporal operators about what two displacements do."""
    inside = (v for v in walk(test, scenario.values) if isinstance(v, PassCall))
    calls = [call for call in inside if call.verb in ("signal", "number", "monitor")]
    work = sum(
        getattr(scenario.kind(call)[1], "cost", 0.0)
        * (_PROJECTION if _is_apart(call, scenario) else 1.0)
        for call in calls
    )
    if isinstance(test, Condition):
        return work + 4.0 * sum(node.temporal for node in test.formula.walk())
    return work + 100.0


def _is_apart(call: PassCall, scenario: IndexedScenario) -> bool:
    """Whether a call compares roads of different roots, by the nearest point."""
    roots = set()
    for entity in entities_in(call, scenario.values):
        thing: Any = scenario.roads.get(entity.name) or scenario.networks.get(entity.name)
        if thing is not None:
            links = [link for link in scenario.chain(thing) if link.name not in scenario.images]
            roots.add((links[-1].name, any(link.name in scenario.roads for link in links)))
    return len(roots) > 1


def _names(test: Condition | PassCall, scenario: IndexedScenario) -> frozenset[str]:
    named = {e.name for e in entities_in(test, scenario.values)}
    for actor in [scenario.actors[name] for name in named if name in scenario.actors]:
        named |= _actor_names(actor, scenario)
    return frozenset(named)


def _actor_names(actor: Actor, scenario: IndexedScenario) -> set[str]:
    values = [actor.at, *(value for _, value in actor.options)]
    names = {e.name for value in values for e in entities_in(value, scenario.values)} - {actor.name}
    names |= {actor.on} if actor.on is not None else set()
    for name in list(names):
        if name in scenario.actors:
            names |= _actor_names(scenario.actors[name], scenario)
    return names


def influences(test: Condition | PassCall, scenario: IndexedScenario) -> frozenset[str]:
    """The places of all draws that can change a verdict, through the things that it names."""
    places = {draw.place for draw in draws_in(test, scenario.values)}
    for name in _names(test, scenario):
        places |= draws_of_thing(name, scenario)
    return frozenset(places)


def draws_of_thing(name: str, scenario: IndexedScenario) -> set[str]:
    """The places of the draws behind a road, network, image, agent or object."""
    if name in scenario.actors:
        actor = scenario.actors[name]
        values = (actor.at, *(value for _, value in actor.options))
        return {d.place for value in values for d in draws_in(value, scenario.values)}
    thing: Any = (
        scenario.roads.get(name) or scenario.networks.get(name) or scenario.images.get(name)
    )
    places: set[str] = set()
    for link in scenario.chain(thing):
        values = (*(value for _, value in link.options), *link.passes)
        places |= {d.place for value in values for d in draws_in(value, scenario.values)}
        # A pass that draws by itself (`harmonics`) differs between candidates without any draw.
        places |= {call.place for call in link.passes if _draws_itself(call, scenario)}
        if scenario.is_varying(name):
            places.add(f"{name}/select")
    return places


def _draws_itself(call: PassCall, scenario: IndexedScenario) -> bool:
    kind: Any = scenario.kind(call)[1]
    return bool(getattr(kind, "is_random", False))


def _placed(actor: Actor, scenario: IndexedScenario) -> Requirement:
    """An agent or object on a road begins on the road."""

    def rho(candidates: CandidateBatch) -> Floats:
        from ..world.placement import room

        return room(actor, candidates)

    names = frozenset(_actor_names(actor, scenario))
    places: set[str] = {d.place for v in (actor.at,) for d in draws_in(v, scenario.values)}
    for name in names:
        places |= draws_of_thing(name, scenario)
    return Requirement(
        actor.name,
        f"`{actor.name}` begins on `{actor.on}`",
        rho,
        8.0 if any(isinstance(v, Draw) for v in walk(actor.at, scenario.values)) else 6.0,
        names,
        frozenset(places),
        implied=True,
        span=actor.span,
    )


def _bent_roads(scenario: IndexedScenario) -> list[str]:
    things: tuple[Road | Network, ...] = (*scenario.roads.values(), *scenario.networks.values())
    return [thing.name for thing in things if any(call.verb == "perturb" for call in thing.passes)]


def _unfolded(name: str, scenario: IndexedScenario) -> Requirement:
    """A road does not run backwards where it was pushed beyond the center of a bend."""

    def rho(candidates: CandidateBatch) -> Floats:
        from ..world.networks import edge_batch, network_root
        from ..world.roads import road_batch

        if name in scenario.roads:
            batches = [road_batch(name, candidates)]
        else:
            network = scenario.networks[name]
            edges = network_root(network, candidates).edges
            batches = [edge_batch(network, edge.id, candidates) for edge in edges]
        folded = np.zeros(candidates.count, dtype=bool)
        for batch in batches:
            folded |= batch.folded
        return np.where(folded, -1.0, 1.0)

    thing: Any = scenario.roads.get(name) or scenario.networks[name]
    places = frozenset(draws_of_thing(name, scenario))
    text = f"`{name}` does not fold back on itself"
    return Requirement(name, text, rho, 3.0, frozenset([name]), places, True, None, thing.span)
