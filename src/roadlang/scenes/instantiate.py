"""One candidate made into a scene."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache, partial
from importlib.metadata import PackageNotFoundError, version
from pathlib import PurePath
from typing import Any

import numpy as np

from ..diagnostics import Diagnostic
from ..evaluate.candidates import CandidateBatch, draw_place, fixed_candidate
from ..evaluate.concrete import call_of, concrete
from ..evaluate.draw_record import DrawRecord
from ..evaluate.evaluation import evaluate, named
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scenario import Input, ScenarioConstraint
from ..ir.scene import Provenance, Scene, Verdict
from ..ir.values import Condition, PassCall
from ..judging.profiles import robustness_profiles, scene_signals, tightest
from ..judging.verdicts import verdict
from ..world.aliasing import aliasing_remarks
from ..world.networks import network_root
from ..world.roads import road_root
from .actors import legend_objects, scene_actors
from .junction_warnings import junction_warnings
from .roads import scene_networks, scene_roads
from .start_gaps import slowed_behind
from .start_speeds import keep_distance


@dataclass(frozen=True)
class ConcreteScene:
    """A scene, and what is to be said of how it was made: by extractors, of perturbations."""

    scene: Scene
    remarks: tuple[str, ...]
    warnings: tuple[Diagnostic, ...] = ()


def instantiate(
    candidates: CandidateBatch, index: int, overrides: Mapping[str, str]
) -> ConcreteScene:
    """The scene of the only candidate, which has a record; `index` is the scene's number.

    Evaluated alone, so that its bytes do not depend on the batch that it was found in.
    """
    source = candidates.scenario.source
    scene = replace(
        _driven(candidates, index, overrides),
        signals=scene_signals(candidates),
        requirements=tuple(_judged(item, candidates) for item in source.requirements),
        expectations=tuple(_judged(item, candidates) for item in source.expectations),
    )
    scene = _with_draws(scene, candidates)
    roots = [network_root(network, candidates) for network in source.networks]
    remarks = [remark for root in roots for remark in root.remarks]
    # Without the record of draws: what is run again is not drawn again.
    remarks += aliasing_remarks(candidates.take(np.zeros(1, dtype=np.intp)))
    return ConcreteScene(scene, tuple(remarks), junction_warnings(source.networks, candidates))


def driven_scene(candidates: CandidateBatch, index: int, overrides: Mapping[str, str]) -> Scene:
    """The scene without what only people and figures want: requirements, signals, profiles.

    It is driven as the scene of `instantiate` is, and made in a fraction of the time.
    """
    return _with_draws(_driven(candidates, index, overrides), candidates)


def _driven(candidates: CandidateBatch, index: int, overrides: Mapping[str, str]) -> Scene:
    """The same, without what was drawn."""
    source = candidates.scenario.source
    values = {item.name: _plain(named(item.name, candidates), candidates) for item in source.values}
    world = {
        name: _plain(evaluate(value, candidates), candidates)
        for name, value in source.world.items()
    }
    objects = (*scene_actors(source.objects, candidates), *legend_objects(candidates))
    networks = scene_networks(candidates)
    agents = scene_actors(source.agents, candidates)
    free = keep_distance(source.agents, agents, candidates)
    return Scene(
        name=source.header.name,
        title=source.header.title,
        index=index,
        provenance=provenance(candidates, index, overrides),
        values=values,
        networks=networks,
        roads=scene_roads(candidates),
        agents=slowed_behind(agents, objects, free, networks),
        objects=objects,
        world=world,
        expectations=tuple(_expected(item, candidates) for item in source.expectations),
        simulate=None if source.simulate is None else call_of(source.simulate, candidates),
    )


def _expected(constraint: ScenarioConstraint, candidates: CandidateBatch) -> Verdict:
    """What is expected of a drive is made once where it is the same in every scene."""
    test, dependencies = constraint.test, candidates.scenario.dependencies
    is_of_drive = isinstance(test, Condition) and test.domain == "drive"
    if not is_of_drive or dependencies.differ(test):
        return verdict(constraint, candidates)
    return candidates.root(
        ("expected", constraint.name), is_drawn=False, make=partial(verdict, constraint)
    )


def _with_draws(scene: Scene, candidates: CandidateBatch) -> Scene:
    """The scene with all that was drawn so far."""
    assert candidates.record is not None
    draws = _draws(candidates.record, candidates)
    return replace(scene, draws=draws, units=_units(candidates.scenario, draws))


def fixed_remarks(scenario: IndexedScenario) -> tuple[str, ...]:
    """Remarks of extractors on the networks that are the same in every scene."""
    fixed = [item for item in scenario.networks.values() if not scenario.is_varying(item.name)]
    roots = [network_root(network, fixed_candidate(scenario)) for network in fixed]
    return tuple(remark for root in roots for remark in root.remarks)


def _judged(constraint: ScenarioConstraint, candidates: CandidateBatch) -> Verdict:
    found = verdict(constraint, candidates)
    if not isinstance(constraint.test, Condition):
        return found
    profiles = robustness_profiles(constraint.test, candidates)
    return replace(found, profiles=profiles, tightest=tightest(constraint.test, profiles))


def provenance(candidates: CandidateBatch, index: int, overrides: Mapping[str, str]) -> Provenance:
    """What a scene was made from and by."""
    scenario = candidates.scenario
    return Provenance(
        roadlang=_version("roadlang"),
        seed=candidates.seed,
        scene=index,
        attempt=int(candidates.attempts[0]),
        inputs={item.path: item.sha256 for item in _inputs(candidates)},
        plugins=scenario.origins(),
        source=_scene_file(scenario),
        overrides=dict(overrides),
    )


def _scene_file(scenario: IndexedScenario) -> str:
    """The name of the scene file, wherever it lies; empty for a scenario that is of no file."""
    inputs = scenario.source.inputs
    return PurePath(inputs[0].path).name if inputs else ""


@cache
def _version(distribution: str) -> str:
    try:
        return version(distribution)
    except PackageNotFoundError:
        return "0+unknown"


def _inputs(candidates: CandidateBatch) -> list[Input]:
    """The files that all networks and roads come from, by path."""
    scenario = candidates.scenario
    networks = [network_root(network, candidates) for network in scenario.networks.values()]
    roads = [road_root(name, candidates) for name in scenario.roads]
    found = {item for network in networks for item in network.inputs}
    found |= {item for road in roads for item in road.inputs}
    return sorted(found, key=lambda item: item.path)


def _draws(record: DrawRecord, candidates: CandidateBatch) -> dict[str, Any]:
    """Every random value by its place; where there are several, by number (`place[2]`)."""
    return {name: _plain(value, candidates) for name, value in sorted(record.values.items())}


def _units(scenario: IndexedScenario, draws: Mapping[str, Any]) -> dict[str, str]:
    """The SI units of values and draws that are quantities; other values have none."""
    named = {
        item.name: item.dimension.unit
        for item in scenario.source.values
        if item.dimension is not None
    }
    drawn = scenario.once(
        "units of draws", lambda: {draw.place: draw.dimension.unit for draw in scenario.draws()}
    )
    named |= {name: drawn.get(draw_place(name), "") for name in draws}
    return {name: unit for name, unit in sorted(named.items()) if unit}


def _plain(value: Any, candidates: CandidateBatch) -> Any:
    if isinstance(value, np.ndarray) and value.dtype == float and value.size == 1:
        number: float = value.item()
        if math.isfinite(number):
            return number
    if isinstance(value, PassCall):
        return value.kind.rpartition(".")[2]
    if isinstance(value, np.ndarray) and value.dtype == object:
        return _plain(value.reshape(-1)[0], candidates)
    return concrete(value, candidates)
