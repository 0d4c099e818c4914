"""Requirements that no file writes: agents begin on their roads, roads do not fold, and no
perturbation is too short for the stations."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from ..diagnostics import Code, DiagnosticError, diagnose
from ..evaluate.candidates import CandidateBatch
from ..evaluate.indexed_scenario import IndexedScenario
from ..geometry.arrays import Floats
from ..ir.scenario import ScenarioActor, ScenarioNetwork, ScenarioRoad
from ..ir.values import PassCall, RandomValue
from ..world.networks.networks import edge_batch, network_root
from ..world.perturbing.shortest_features import features_of_candidates
from ..world.perturbing.stations import STATIONS_PER_FEATURE, unknown_features
from ..world.placement.placement import (
    blocker_of,
    lacking_road,
    least_spacing,
    placed_tries,
    room_among_others,
    room_on_road,
)
from ..world.placement.placement_causes import beyond_road, cause_of_place, lane_fault
from ..world.placement.placement_order import draws_of
from ..world.placement.route_faults import route_fault
from ..world.placement_faults import beyond_the_end, row_or_anywhere
from ..world.roads.roads import road_batch, road_root
from .influences import influences_on_place, influences_on_start, is_geometry_random
from .requirement import Requirement


def begins_on_road(actor: ScenarioActor, scenario: IndexedScenario) -> Requirement:
    """An agent or object on a road begins on the road; its very ends belong to it."""
    drawn = any(
        isinstance(value, RandomValue) for value in scenario.dependencies.contents(actor.at)
    )
    causes = influences_on_start(actor, scenario)
    return Requirement(
        name=actor.name,
        text=f"`{actor.name}` begins on `{actor.on}`",
        rho=partial(_on_road, actor, not causes.is_random),
        blame=partial(_beyond_the_end, actor),
        cost=8.0 if drawn else 6.0,
        names=causes.names,
        is_random=causes.is_random,
        implied=True,
        span=actor.span,
    )


def _on_road(actor: ScenarioActor, is_fixed: bool, candidates: CandidateBatch) -> Floats:
    """(V,) as `room_on_road`. Raises RL613, RL617 and RL618 where no draw has a say."""
    room = room_on_road(actor, candidates)
    if is_fixed and (room < 0.0).any():
        fault = lane_fault(actor, candidates)
        if fault is None and actor.on in candidates.scenario.networks:
            fault = route_fault(actor, candidates)
        if fault is not None:
            raise DiagnosticError(fault)
    return room


def _beyond_the_end(actor: ScenarioActor, candidates: CandidateBatch) -> str | None:
    lacking = lacking_road(actor, candidates)
    if lacking is None:
        return cause_of_place(actor, candidates)
    copy, meters = lacking
    name = f"{actor.name}[{copy}]" if "count" in actor.options else actor.name
    road = f"`{actor.on}`" if actor.on in candidates.scenario.roads else "its road"
    return beyond_the_end(name, meters, road)


def _in_the_way(actor: ScenarioActor, candidates: CandidateBatch) -> str | None:
    other = blocker_of(actor, candidates)
    if other is None:
        return cause_of_place(actor, candidates) or beyond_road(actor, candidates)
    if other == actor.name:
        found = f"copies of `{other}` are in the way of each other"
        if "spacing" in actor.options or draws_of(actor, candidates.scenario):
            return found
        return f"{found}; {_places_apart(actor, candidates, more=' or more')}"
    return f"`{other}` is in the way of `{actor.name}`"


def has_room(actor: ScenarioActor, scenario: IndexedScenario) -> Requirement:
    """An agent or object overlaps nothing that was placed before it, and is on the road where it
    was placed again."""
    causes = influences_on_place(actor, scenario)
    return Requirement(
        name=actor.name,
        text=f"there is room for `{actor.name}`",
        rho=partial(_room, actor, not causes.is_random),
        blame=partial(_in_the_way, actor),
        tries=partial(placed_tries, actor),
        cost=0.0,
        last=True,
        names=causes.names,
        is_random=causes.is_random,
        implied=True,
        span=actor.span,
    )


def _room(actor: ScenarioActor, is_fixed: bool, candidates: CandidateBatch) -> Floats:
    """(V,) as `room_among_others`. Raises RL616 where two stand where no draw has a say."""
    room = room_among_others(actor, candidates)
    if is_fixed and (room < 0.0).any():
        other = blocker_of(actor, candidates) or actor.name
        help_ = f"leave {-float(room.min()):.2g}m more, or write `apart: 0.1m` for less room, "
        help_ += "or `overlap: true` if they may stand in each other"
        if other == actor.name and "spacing" not in actor.options:
            help_ = _places_apart(actor, candidates)
        elif _runs_back(actor, candidates.scenario):
            help_ = "`spacing` leads away from the other agent or object: leave out its sign"
        raise DiagnosticError(
            diagnose(Code.NO_ROOM, actor.span, name=actor.name, other=other, help=help_)
        )
    return room


def _places_apart(actor: ScenarioActor, candidates: CandidateBatch, more: str = "") -> str:
    """What to do with copies that all stand in one place; `more`: of those that differ in length
    between scenes."""
    if actor.on is None:
        return "give each copy a place of its own: `at (10m..40m, 20m)` draws one for each"
    return row_or_anywhere(least_spacing(actor, candidates), more)


def _runs_back(actor: ScenarioActor, scenario: IndexedScenario) -> bool:
    """Whether a negative `spacing` leads the copies back to what they are placed by."""
    if not isinstance(actor.at, PassCall) or "spacing" not in actor.options:
        return False
    _, high = scenario.value_bounds.of(actor.options["spacing"])
    return bool(high < 0.0)


def perturbed_names(scenario: IndexedScenario) -> list[str]:
    """The roads and networks that have a `perturb` of their own."""
    return [
        source.name
        for source in _geometries(scenario)
        if any(call.verb == "perturb" for call in source.passes)
    ]


def _geometries(scenario: IndexedScenario) -> tuple[ScenarioRoad | ScenarioNetwork, ...]:
    return (*scenario.roads.values(), *scenario.networks.values())


def _implied(
    name: str,
    scenario: IndexedScenario,
    text: str,
    rho: Callable[[str, CandidateBatch], Floats],
    cost: float,
) -> Requirement:
    """A requirement on one road or network."""
    return Requirement(
        name=name,
        text=text,
        rho=partial(rho, name),
        cost=cost,
        names=frozenset([name]),
        is_random=is_geometry_random(name, scenario),
        implied=True,
        span=scenario.declaration(name).span,
    )


def does_not_fold(name: str, scenario: IndexedScenario) -> Requirement:
    """A road does not run backward where it was pushed beyond the center of a bend."""
    text = f"`{name}` does not fold back on itself"
    return _implied(name, scenario, text, _unfolded, cost=3.0)


def _unfolded(name: str, candidates: CandidateBatch) -> Floats:
    """(V,) 1 where no road of that name folds, else -1."""
    scenario = candidates.scenario
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


def hidden_perturbations(scenario: IndexedScenario) -> list[str]:
    """The roads and networks whose draws may make a wave too short for their stations."""
    return [source.name for source in _geometries(scenario) if unknown_features(source, scenario)]


def is_shown_by_stations(name: str, scenario: IndexedScenario) -> Requirement:
    """No wave or bump of a road is too short for its stations."""
    text = f"`{name}` has no wave or bump shorter than {STATIONS_PER_FEATURE} stations"
    return _implied(name, scenario, text, _room_for_stations, cost=2.0)


def _room_for_stations(name: str, candidates: CandidateBatch) -> Floats:
    """(V,) meters that the shortest wave or bump is longer than the stations need."""
    scenario = candidates.scenario
    source = scenario.declaration(name)
    assert isinstance(source, ScenarioRoad | ScenarioNetwork)
    if isinstance(source, ScenarioRoad):
        frames = {0: road_root(name, candidates).frame}
    else:
        root = network_root(source, candidates)
        frames = {edge.id: root.frame(edge.id) for edge in root.edges}
    room = np.full(candidates.count, np.inf)
    for element, frame in frames.items():
        needed = STATIONS_PER_FEATURE * float(np.diff(frame.stations).max())
        for call in unknown_features(source, scenario):
            length, closed = frame.curve.length, frame.closed
            feature = features_of_candidates(call, candidates, element, length, closed)
            room = np.minimum(room, feature - needed * (1.0 - 1e-9))
    return room
