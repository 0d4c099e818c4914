"""One candidate made into a scene."""

from __future__ import annotations

from dataclasses import replace
from importlib.metadata import PackageNotFoundError, version
from typing import Any

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..evaluate.evaluation import evaluate, named
from ..ir.scenario import Constraint
from ..ir.scene import Provenance, Scene, Verdict
from ..ir.values import Condition, PassCall
from ..judging.profiles import robustness_profiles, scene_signals, tightest
from ..judging.verdicts import verdict
from .actors import call_of, concrete, legend_objects, scene_actors
from .roads import scene_networks, scene_roads


def instantiate(
    candidates: CandidateBatch, index: int, overrides: dict[str, str] | None = None
) -> Scene:
    """The scene of the only candidate; `index` is its number.

    Evaluated by itself, so that its bytes do not depend on what it was searched with.
    """
    scenario = candidates.scenario
    source = scenario.source
    # All that is drawn is drawn before it is listed.
    roads, networks = scene_roads(candidates), scene_networks(candidates)
    agents = scene_actors(source.agents, candidates)
    objects = (*scene_actors(source.objects, candidates), *legend_objects(candidates))
    values = {item.name: _plain(named(item.name, candidates), candidates) for item in source.values}
    world = {name: _plain(evaluate(value, candidates), candidates) for name, value in source.world}
    simulate = None if source.simulate is None else call_of(source.simulate, candidates)
    return Scene(
        name=source.header.name,
        title=source.header.title,
        index=index,
        provenance=provenance(candidates, index, overrides or {}),
        values=values,
        draws=_draws(candidates),
        networks=networks,
        roads=roads,
        agents=agents,
        objects=objects,
        world=world,
        signals=scene_signals(candidates),
        requirements=tuple(_judged(item, candidates) for item in source.requirements),
        expectations=tuple(_judged(item, candidates) for item in source.expectations),
        simulate=simulate,
    )


def _judged(constraint: Constraint, candidates: CandidateBatch) -> Verdict:
    found = verdict(constraint, candidates)
    if not isinstance(constraint.test, Condition):
        return found
    profiles = robustness_profiles(constraint.test, candidates)
    return replace(found, profiles=profiles, tightest=tightest(constraint.test, profiles))


def provenance(candidates: CandidateBatch, index: int, overrides: dict[str, str]) -> Provenance:
    """What a scene was made from and by."""
    scenario = candidates.scenario
    return Provenance(
        roadlang=_version("roadlang"),
        seed=candidates.seed,
        scene=index,
        attempt=int(candidates.attempts[0]),
        inputs=dict(sorted(scenario.digests.items())),
        plugins=scenario.origins(),
        overrides=overrides,
    )


def _version(distribution: str) -> str:
    try:
        return version(distribution)
    except PackageNotFoundError:
        return "0+unknown"


def _draws(candidates: CandidateBatch) -> dict[str, Any]:
    """Every random value by its place; where there are several, by number (`place[2]`)."""
    named: dict[str, Any] = {}
    for key, value in candidates.kept("draw"):
        place, element = key[1], key[2]
        name = f"{place}[{element}]" if element else place
        named[name] = _plain(value, candidates)
    return dict(sorted(named.items()))


def _plain(value: Any, candidates: CandidateBatch) -> Any:
    if isinstance(value, PassCall):
        return value.kind.rpartition(".")[2]
    if isinstance(value, np.ndarray) and value.dtype == object:
        return _plain(value.reshape(-1)[0], candidates)
    return concrete(value, candidates)
